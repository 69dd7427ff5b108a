#pragma once
// Grounds that the points of a sweep and all threads share.

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>

namespace flyrock {

/// Grounds by the text of the terrain that they are made from. A ground is made once, by the first who asks;
/// others wait for it. The store keeps at most 64 grounds and 1 GiB, the least recently used go first; who
/// holds a ground keeps it alive. Threads may use one store.
class GroundStore {
 public:
  explicit GroundStore(std::size_t most_grounds = 64, std::size_t most_bytes = std::size_t{1} << 30)
      : most_grounds_(most_grounds), most_bytes_(most_bytes) {}

  struct Made {
    std::shared_ptr<const void> ground;
    std::size_t bytes = 0;
    bool draws = false;  ///< it holds for one trial only, and is not kept
  };
  std::shared_ptr<const void> get(const std::string& key, const std::function<Made()>& make);

  /// Leaves what was built of a terrain while the scenario was read, for the one who makes its ground: a file
  /// is then read once. Only the last that was left is kept.
  void leave(const std::string& key, std::shared_ptr<void> shape);
  /// What was left under this key, which it then is no longer; nullptr for another key.
  std::shared_ptr<void> take(const std::string& key);

 private:
  struct Entry {
    std::mutex making;
    std::shared_ptr<const void> ground;  ///< guarded by `making`
    bool draws = false;                  ///< guarded by `making`
    std::size_t bytes = 0;               ///< guarded by the store, as the rest; 0: not kept
    std::uint64_t used = 0;
  };
  std::shared_ptr<Entry> entry_of(const std::string& key);
  void keep(Entry& entry, std::size_t bytes);

  std::size_t most_grounds_, most_bytes_;
  std::mutex mutex_;
  std::uint64_t clock_ = 0;
  std::map<std::string, std::shared_ptr<Entry>> entries_;
  std::string left_key_;
  std::shared_ptr<void> left_;
};

}  // namespace flyrock
