#pragma once
// The friction problems of ../shared/data/fclib, which stand beside the project.

#include <string>

namespace flyrock::test {

inline const std::string fclib_folder = FLYROCK_SOURCE_DIR "/../shared/data/fclib/";

}  // namespace flyrock::test
