#pragma once
// The FCLIB friction problems in ../shared/data/fclib, outside the project's folder.

#include <string>

namespace flyrock::test {

inline const std::string fclib_folder = FLYROCK_SOURCE_DIR "/../shared/data/fclib/";

}  // namespace flyrock::test
