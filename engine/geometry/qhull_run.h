#pragma once
// One run of Qhull, whose messages are written to memory.

#include <libqhull_r/qhull_ra.h>

#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace flyrock {

class QhullRun {
 public:
  /// `coordinates` of points in `dimension` dimensions, one after the other, outlive the run; `command` as of
  /// the program qhull.
  QhullRun(std::vector<double>& coordinates, int dimension, std::string command) {
    messages_ = open_memstream(&text_, &size_);
    qh_zero(&qh_, messages_);
    failed_ = qh_new_qhull(&qh_, dimension, static_cast<int>(coordinates.size()) / dimension,
                           coordinates.data(), False, command.data(), nullptr, messages_) != 0;
  }
  ~QhullRun() {
    qh_freeqhull(&qh_, !qh_ALL);
    int held = 0, total = 0;
    qh_memfreeshort(&qh_, &held, &total);
    std::fclose(messages_);
    std::free(text_);
  }
  QhullRun(const QhullRun&) = delete;
  QhullRun& operator=(const QhullRun&) = delete;

  bool failed() const { return failed_; }
  qhT* get() { return &qh_; }

 private:
  qhT qh_;
  bool failed_ = false;
  std::FILE* messages_ = nullptr;
  char* text_ = nullptr;
  std::size_t size_ = 0;
};

}  // namespace flyrock
