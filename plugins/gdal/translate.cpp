// flyrock_gdal.so: writes maps and layers in the formats of GDAL, as its programs gdal_translate and ogr2ogr
// do.

#include <cpl_conv.h>
#include <cpl_error.h>
#include <gdal.h>
#include <gdal_utils.h>

#include <memory>
#include <string>
#include <vector>

#include "survey/gdal_module.h"

namespace flyrock {

namespace {

struct CloseTranslated {
  void operator()(void* dataset) const { GDALClose(dataset); }
};
using Dataset = std::unique_ptr<void, CloseTranslated>;

std::vector<char*> pointers_to(std::vector<std::string>& words) {
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  return pointers;
}

/// Closes what was made, so that what it has is written; false if something went wrong.
bool is_written(GDALDatasetH made, int misused) {
  GDALClose(made);
  return made && !misused && CPLGetLastErrorType() < CE_Failure;
}

/// Opens `from` and calls translate(source); false if either goes wrong.
template <class Translate>
bool translated(const std::string& from, unsigned kind, const Translate& translate) {
  CPLPushErrorHandler(CPLQuietErrorHandler);
  CPLErrorReset();
  GDALAllRegister();
  const Dataset source(GDALOpenEx(from.c_str(), kind, nullptr, nullptr, nullptr));
  const bool is_done = source && translate(source.get());
  CPLPopErrorHandler();
  return is_done;
}

}  // namespace

extern "C" __attribute__((visibility("default"))) bool flyrock_translate_raster(
    const std::vector<std::string>& options, const std::string& from, const std::string& to) {
  CPLSetThreadLocalConfigOption("AAIGRID_DATATYPE", "Float64");
  return translated(from, GDAL_OF_RASTER, [&](GDALDatasetH source) {
    std::vector<std::string> words = options;
    const std::unique_ptr<GDALTranslateOptions, decltype(&GDALTranslateOptionsFree)> parsed(
        GDALTranslateOptionsNew(pointers_to(words).data(), nullptr), GDALTranslateOptionsFree);
    int misused = 0;
    const GDALDatasetH made = GDALTranslate(to.c_str(), source, parsed.get(), &misused);
    return is_written(made, misused);
  });
}

extern "C" __attribute__((visibility("default"))) bool flyrock_translate_layers(
    const std::vector<std::string>& options, const std::string& from, const std::string& to) {
  // The time of the change would differ in each export.
  CPLSetThreadLocalConfigOption("OGR_CURRENT_DATE", "2000-01-01T00:00:00.000Z");
  return translated(from, GDAL_OF_VECTOR, [&](GDALDatasetH source) {
    std::vector<std::string> words = options;
    const std::unique_ptr<GDALVectorTranslateOptions, decltype(&GDALVectorTranslateOptionsFree)> parsed(
        GDALVectorTranslateOptionsNew(pointers_to(words).data(), nullptr), GDALVectorTranslateOptionsFree);
    int misused = 0;
    const GDALDatasetH made = GDALVectorTranslate(to.c_str(), nullptr, 1, &source, parsed.get(), &misused);
    return is_written(made, misused);
  });
}

}  // namespace flyrock
