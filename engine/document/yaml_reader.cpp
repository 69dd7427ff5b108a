#include "document/yaml_reader.h"

#include <fmt/format.h>
#include <yaml-cpp/depthguard.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include <map>
#include <sstream>

#include "document/odd_characters.h"
#include "document/printable.h"
#include "document/yaml_text.h"
#include "units/units.h"

namespace flyrock {

namespace {

constexpr std::size_t most_values =
    100000;  // after expansion of aliases, because a few lines can name billions of values

std::size_t count_values(const Value& value) {
  std::size_t count = 1;
  if (const List* list = value.list())
    for (const Value& item : *list) count += count_values(item);
  if (const Map* map = value.map())
    for (const Entry& entry : *map) count += count_values(entry.value);
  return count;
}

bool has_leading_zero(std::string_view text) {
  if (text.starts_with('+') || text.starts_with('-')) text.remove_prefix(1);
  return text.size() > 1 && text[0] == '0' &&
         text.find_first_not_of("0123456789.") == std::string_view::npos && text[1] != '.';
}

/// Ends the reading of a file that is YAML but not a scenario.
struct Refusal {
  Location at;
  std::string text;
};

/// Builds the tree from the parser's events. It uses events instead of YAML::Node because they keep duplicate
/// keys, tags and the place of every scalar.
class TreeBuilder : public YAML::EventHandler {
 public:
  TreeBuilder(std::shared_ptr<const Source> source, Diagnostics& diagnostics)
      : source_(std::move(source)), diagnostics_(diagnostics) {}

  Value take() { return std::move(root_); }
  Location locate(const YAML::Mark& mark);

  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override { finish(make({}, mark), anchor); }
  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& text) override;
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override;
  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    check_tag(mark, tag);
    open_.push_back({make(List{}, mark), anchor, {}, {}, false});
  }
  void OnSequenceEnd() override { close(); }
  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    check_tag(mark, tag);
    open_.push_back({make(Map{}, mark), anchor, {}, {}, false});
  }
  void OnMapEnd() override { close(); }

 private:
  /// A list or map whose end has not been read yet.
  struct Open {
    Value value;
    YAML::anchor_t anchor;
    std::string key;  ///< for a map: the key that waits for its value
    Location key_at;
    bool has_key;
    std::map<std::string, int> line_of = {};  ///< for a map: the line of each key
  };

  Value make(decltype(Value::data) data, const YAML::Mark& mark) {
    Value value;
    value.data = std::move(data);
    value.at = locate(mark);
    return value;
  }
  Value resolve(const YAML::Mark& mark, const std::string& text);
  void check_tag(const YAML::Mark& mark, const std::string& tag);
  void close();
  void finish(Value value, YAML::anchor_t anchor);
  void take_key(const Value& key);
  void add_entry(Open& map, Value value);
  std::string path_of(const std::string& key) const;
  std::string pending_key() const {
    return open_.empty() || !open_.back().has_key ? std::string() : open_.back().key;
  }

  std::shared_ptr<const Source> source_;
  Diagnostics& diagnostics_;
  Value root_;
  std::vector<Open> open_;
  std::map<YAML::anchor_t, Value> anchors_;
  std::size_t values_ = 0;
  /// How far the line of the last mark has been counted, and how many of these bytes do not begin a
  /// character. Kept because a whole file may be one line.
  struct {
    int line = -1, bytes = 0, inner = 0;
  } counted_;
};

/// Marks count bytes from 0; places count characters from 1.
Location TreeBuilder::locate(const YAML::Mark& mark) {
  Location at{source_, mark.line + 1, mark.column + 1};
  if (mark.line >= 0 && mark.line < static_cast<int>(source_->lines.size())) {
    const std::string& line = source_->lines[mark.line];
    if (counted_.line != mark.line || counted_.bytes > mark.column) counted_ = {mark.line, 0, 0};
    for (; counted_.bytes < std::min(mark.column, static_cast<int>(line.size())); ++counted_.bytes)
      if ((line[counted_.bytes] & 0xC0) == 0x80) ++counted_.inner;
    at.column -= counted_.inner;
  }
  return at;
}

void TreeBuilder::check_tag(const YAML::Mark& mark, const std::string& tag) {
  if (!tag.empty() && tag != "?" && tag != "!")
    diagnostics_.error(locate(mark), "", fmt::format("a tag (`{}`) is not part of a scenario", tag));
}

void TreeBuilder::OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                           const std::string& text) {
  check_tag(mark, tag);
  if (const std::string fault = quote_fault(*source_, mark.line, mark.column); !fault.empty())
    diagnostics_.error(locate(mark), path_of(pending_key()), fault);
  if (const std::string fault = text_fault(text); !fault.empty())  // an escape such as "\e" can give one
    diagnostics_.error(locate(mark), path_of(pending_key()), "the text " + fault);
  finish(tag == "?" ? resolve(mark, text) : make(text, mark), anchor);
}

/// A plain scalar: number, true, false or text. `on`, `off`, `yes` and `no` stay text.
Value TreeBuilder::resolve(const YAML::Mark& mark, const std::string& text) {
  if (text == "true" || text == "false") return make(text == "true", mark);
  if (std::optional<double> number = parse_number(text)) {
    Value value = make(*number, mark);
    value.rounded = rounds_to_whole(text);
    return value;
  }
  for (const char* special :
       {".nan", ".NaN", ".NAN", ".inf", ".Inf", ".INF", "+.inf", "-.inf", "-.Inf", "-.INF"})
    if (text == special)
      diagnostics_.error(locate(mark), path_of(pending_key()),
                         fmt::format("`{}` is not a finite number", text));
  Value value = make(text, mark);
  value.leading_zero = has_leading_zero(text);
  return value;
}

void TreeBuilder::OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) {
  auto found = anchors_.find(anchor);
  if (found == anchors_.end()) {
    diagnostics_.error(locate(mark), "", "an alias inside its own anchor has no end");
    finish(make({}, mark), 0);
    return;
  }
  const std::size_t count = count_values(found->second);
  if (values_ + count > most_values)
    throw Refusal{locate(mark), fmt::format("more than {} values, aliases expanded", most_values)};
  values_ += count;
  finish(found->second, 0);
}

void TreeBuilder::close() {
  Open done = std::move(open_.back());
  open_.pop_back();
  finish(std::move(done.value), done.anchor);
}

void TreeBuilder::finish(Value value, YAML::anchor_t anchor) {
  if (++values_ > most_values)
    throw Refusal{Location{source_, 0, 0},
                  fmt::format("more than {} values, expected a scenario", most_values)};
  if (anchor) anchors_[anchor] = value;
  if (open_.empty()) {
    root_ = std::move(value);
    return;
  }
  Open& parent = open_.back();
  if (List* list = parent.value.list())
    list->push_back(std::move(value));
  else if (parent.has_key)
    add_entry(parent, std::move(value));
  else
    take_key(value);
}

void TreeBuilder::take_key(const Value& key) {
  Open& map = open_.back();
  map.has_key = true;
  map.key_at = key.at;
  map.key.clear();
  if (const std::string* text = key.text())
    map.key = *text;
  else
    diagnostics_.error(key.at, path_of(""), fmt::format("a key must be text, this one is {}", key.kind()));
  if (key.text() && map.key.empty()) diagnostics_.error(key.at, path_of(""), "a key must not be empty");
  if (map.key == "<<")
    diagnostics_.error(key.at, path_of(""), "merge keys (`<<`) are not supported: write the keys out");
}

void TreeBuilder::add_entry(Open& map, Value value) {
  map.has_key = false;
  if (map.key.empty() || map.key == "<<") return;  // reported
  const auto [first, is_new] = map.line_of.emplace(map.key, map.key_at.line);
  if (!is_new) {
    diagnostics_.error(map.key_at, path_of(map.key),
                       fmt::format("duplicate key, the first one is in line {}", first->second));
    return;
  }
  map.value.map()->push_back({std::move(map.key), map.key_at, std::move(value)});
}

/// The path of a key of the innermost open map; the path of that map if the key is empty.
std::string TreeBuilder::path_of(const std::string& key) const {
  std::string path;
  for (std::size_t i = 0; i < open_.size(); ++i) {
    const Open& open = open_[i];
    std::string step;
    if (const List* list = open.value.list())
      step = std::to_string(list->size());
    else
      step = i + 1 == open_.size() ? key : open.key;
    if (!step.empty()) path += (path.empty() ? "" : ".") + step;
  }
  return path;
}

/// `{ measure: body.ball.impact[1].time }` is not YAML, and the parser's message does not say why.
std::string bracket_hint(const std::string& message) {
  if (message != YAML::ErrorMsg::END_OF_MAP_FLOW && message != YAML::ErrorMsg::END_OF_SEQ_FLOW) return {};
  return " (a closing bracket is missing, or text with brackets or commas inside a bracket needs quotes)";
}

}  // namespace

std::optional<Value> read_yaml(const std::string& text, const std::string& name, Diagnostics& diagnostics) {
  const std::shared_ptr<const Source> source = source_of(text, name);
  if (text.size() > most_yaml_bytes) {
    diagnostics.error({source, 1, 1}, "", "the file is larger than 4 MiB, expected a scenario");
    return std::nullopt;
  }
  if (has_foreign_bytes(source, diagnostics) || has_tab_indentation(source, diagnostics)) return std::nullopt;
  Diagnostics found;  // of this text only: an earlier error elsewhere is no reason to stop
  TreeBuilder builder(source, found);
  std::istringstream stream(text);
  try {
    YAML::Parser parser(stream);
    if (!parser.HandleNextDocument(builder)) found.error({source, 1, 1}, "", "the file is empty");
    Value root = builder.take();
    TreeBuilder second(source, found);
    if (parser.HandleNextDocument(second))
      found.error(second.take().at, "", "a second document: a scenario is one document");
    if (!found.has_errors()) return root;
  } catch (const Refusal& refusal) {
    found.error(refusal.at, "", refusal.text);
  } catch (const YAML::DeepRecursion& exception) {
    found.error(builder.locate(exception.mark), "", "not YAML: nested too deeply");
  } catch (const YAML::Exception& exception) {
    const Location at = builder.locate(exception.mark);
    found.error(at, "", "not YAML: " + exception.msg + bracket_hint(exception.msg) + hint_of_line(at));
  }
  for (const Diagnostic& diagnostic : found.all())
    diagnostics.error(diagnostic.at, diagnostic.path, diagnostic.text);
  return std::nullopt;
}

}  // namespace flyrock
