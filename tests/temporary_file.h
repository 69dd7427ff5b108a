#pragma once
// A file that a test writes, gone at the end of the test.

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

/// `name` gives the ending that a reader may go by. Test processes that run beside each other get files of
/// their own.
struct TemporaryFile {
  std::string path;
  TemporaryFile(const std::string& name, const std::string& content)
      : path((std::filesystem::temp_directory_path() / ("flyrock_" + std::to_string(::getpid()) + "_" + name))
                 .string()) {
    write(content);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() { std::filesystem::remove(path); }

  void write(const std::string& content) const { std::ofstream(path, std::ios::binary) << content; }
};
