#pragma once
// What all deformable blocks of the same mesh, material and step share.

#include "elastic/elastic_step.h"

namespace flyrock {

/// Its columns (ElasticStep::column) are found when a node touches for the first time, so that the
/// blocks of one thread only may share it.
template <int D>
struct ElasticBlock {
  ElasticBlock(ElasticMesh<D> mesh, const ElasticMaterial& material, double step_length, double step_theta)
      : model(std::move(mesh), material),
        h(step_length),
        theta(step_theta),
        step(model, step_length, step_theta) {}
  ElasticBlock(const ElasticBlock&) = delete;
  ElasticBlock& operator=(const ElasticBlock&) = delete;

  ElasticModel<D> model;
  double h, theta;
  ElasticStep<D> step;
};

}  // namespace flyrock
