#pragma once
// What all deformable blocks of the same mesh, material and step share.

#include "elastic/elastic_step.h"

namespace flyrock {

/// In 2D. Its columns (ElasticStep::column) are found when a node touches for the first time, so that the
/// blocks of one thread only may share it.
struct ElasticBlock {
  ElasticBlock(ElasticMesh<2> mesh, const ElasticMaterial& material, double step_length, double step_theta)
      : model(std::move(mesh), material),
        h(step_length),
        theta(step_theta),
        step(model, step_length, step_theta) {}
  ElasticBlock(const ElasticBlock&) = delete;
  ElasticBlock& operator=(const ElasticBlock&) = delete;

  ElasticModel<2> model;
  double h, theta;
  ElasticStep<2> step;
};

}  // namespace flyrock
