#include "calls.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <iostream>
#include <stdexcept>

#include "cli/dispatch.h"

namespace flyrock::fuzz {

namespace {

/// A word as a shell takes it.
std::string quoted(const std::string& word) {
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

void flush() {
  std::cout.flush();
  std::cerr.flush();
  std::fflush(stdout);
  std::fflush(stderr);
}

}  // namespace

Capture::Capture() : out_(std::tmpfile()), err_(std::tmpfile()) {
  if (!out_ || !err_) throw std::runtime_error("cannot make temporary files");
}

Capture::~Capture() {
  std::fclose(out_);
  std::fclose(err_);
}

void Capture::redirect() const {
  flush();
  ::dup2(::fileno(out_), STDOUT_FILENO);
  ::dup2(::fileno(err_), STDERR_FILENO);
}

void Capture::clear() const {
  flush();
  for (std::FILE* file : {out_, err_}) {
    if (::ftruncate(::fileno(file), 0) != 0) throw std::runtime_error("cannot empty a temporary file");
    ::lseek(::fileno(file), 0, SEEK_SET);
  }
}

std::string Capture::err() const {
  flush();
  std::string text;
  char block[4096];
  for (ssize_t count;
       (count = ::pread(::fileno(err_), block, sizeof block, static_cast<off_t>(text.size()))) > 0;)
    text.append(block, static_cast<std::size_t>(count));
  return text;
}

int Calls::operator()(const cli::Arguments& arguments, ErrorForm form) {
  std::string line = "flyrock";
  for (const std::string& word : arguments) line += ' ' + quoted(word);
  lines_.push_back(line);
  if (!capture_) {
    fmt::print("$ {}\n", line);
    const int code = cli::dispatch(arguments);
    flush();
    fmt::print("exit code {}\n", code);
    return code;
  }
  capture_->clear();
  const int code = cli::dispatch(arguments);
  err_ = capture_->err();
  gravest_ = std::max(gravest_, code);
  if (fault_.empty()) fault_ = fault_of(arguments, code, err_, form);
  if (code == cli::faults && rocks_.empty()) rocks_ = err_.substr(0, err_.find('\n'));
  return code;
}

}  // namespace flyrock::fuzz
