#include "survey/well_known_text.h"

#include <algorithm>
#include <cctype>
#include <optional>

namespace flyrock {

namespace {

constexpr int deepest = 50;

class WktReader {
 public:
  explicit WktReader(const std::string& text) : text_(text) {}

  std::vector<WktNode> read() {
    std::vector<WktNode> nodes;
    skip();
    while (at_ < text_.size()) {
      std::optional<WktNode> node = node_at(0);
      if (!node) return {};
      nodes.push_back(std::move(*node));
      while (skip(), at_ < text_.size() && text_[at_] == ',') ++at_;
    }
    return nodes;
  }

 private:
  void skip() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_]))) ++at_;
  }

  bool is_bracket(const char* both) const {
    return at_ < text_.size() && (text_[at_] == both[0] || text_[at_] == both[1]);
  }

  std::string word() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && !std::isspace(static_cast<unsigned char>(text_[at_])) &&
           std::string_view("[](),\"").find(text_[at_]) == std::string_view::npos)
      ++at_;
    return text_.substr(begin, at_ - begin);
  }

  std::optional<std::string> quoted() {
    const std::size_t end = text_.find('"', at_ + 1);
    if (end == text_.npos) return std::nullopt;
    std::string text = text_.substr(at_ + 1, end - at_ - 1);
    at_ = end + 1;
    return text;
  }

  std::optional<WktNode> node_at(int depth) {
    WktNode node;
    node.keyword = word();
    std::transform(node.keyword.begin(), node.keyword.end(), node.keyword.begin(),
                   [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    skip();
    if (node.keyword.empty() || !is_bracket("[(") || depth > deepest) return std::nullopt;
    ++at_;
    while (true) {
      skip();
      if (at_ >= text_.size()) return std::nullopt;
      if (is_bracket("])")) {
        ++at_;
        return node;
      }
      if (text_[at_] == ',') {
        ++at_;
        continue;
      }
      if (!read_entry(node, depth)) return std::nullopt;
    }
  }

  /// A text, a number or word, or a node.
  bool read_entry(WktNode& node, int depth) {
    if (text_[at_] == '"') {
      const auto text = quoted();
      if (text) node.values.push_back(*text);
      return text.has_value();
    }
    const std::size_t begin = at_;
    std::string plain = word();
    skip();
    if (!is_bracket("[(")) {
      node.values.push_back(std::move(plain));
      return at_ > begin;
    }
    at_ = begin;
    std::optional<WktNode> child = node_at(depth + 1);
    if (child) node.children.push_back(std::move(*child));
    return child.has_value();
  }

  const std::string& text_;
  std::size_t at_ = 0;
};

}  // namespace

const WktNode* WktNode::child(std::initializer_list<std::string_view> keywords) const {
  const auto found = std::find_if(children.begin(), children.end(), [&](const WktNode& one) {
    return std::find(keywords.begin(), keywords.end(), one.keyword) != keywords.end();
  });
  return found == children.end() ? nullptr : &*found;
}

std::vector<WktNode> read_well_known_text(const std::string& text) { return WktReader(text).read(); }

}  // namespace flyrock
