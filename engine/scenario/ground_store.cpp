#include "scenario/ground_store.h"

#include <algorithm>

namespace flyrock {

std::shared_ptr<GroundStore::Entry> GroundStore::entry_of(const std::string& key) {
  const std::lock_guard lock(mutex_);
  std::shared_ptr<Entry>& entry = entries_[key];
  if (!entry) entry = std::make_shared<Entry>();
  entry->used = ++clock_;
  return entry;
}

std::shared_ptr<const void> GroundStore::get(const std::string& key, const std::function<Made()>& make) {
  const std::shared_ptr<Entry> entry = entry_of(key);
  std::unique_lock making(entry->making);
  if (entry->ground) return entry->ground;
  if (entry->draws) {
    making.unlock();  // each trial makes its own
    return make().ground;
  }
  Made made = make();
  entry->draws = made.draws;
  if (made.draws) return made.ground;
  entry->ground = made.ground;
  making.unlock();
  keep(*entry, std::max<std::size_t>(made.bytes, 1));
  return made.ground;
}

void GroundStore::leave(const std::string& key, std::shared_ptr<void> shape) {
  const std::lock_guard lock(mutex_);
  left_key_ = key;
  left_ = std::move(shape);
}

std::shared_ptr<void> GroundStore::take(const std::string& key) {
  const std::lock_guard lock(mutex_);
  return key == left_key_ ? std::move(left_) : nullptr;
}

/// Counts the ground, and drops others while there are too many.
void GroundStore::keep(Entry& entry, std::size_t bytes) {
  const std::lock_guard lock(mutex_);
  entry.bytes = bytes;
  while (true) {
    std::size_t grounds = 0, total = 0;
    auto oldest = entries_.end();
    for (auto one = entries_.begin(); one != entries_.end(); ++one) {
      if (one->second->bytes == 0) continue;
      ++grounds;
      total += one->second->bytes;
      const bool is_older = oldest == entries_.end() || one->second->used < oldest->second->used;
      if (one->second.get() != &entry && is_older) oldest = one;
    }
    if (oldest == entries_.end() || (grounds <= most_grounds_ && total <= most_bytes_)) return;
    entries_.erase(oldest);
  }
}

}  // namespace flyrock
