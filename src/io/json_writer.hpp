// JSON text, written from the outside inwards.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "io/text.hpp"
#include "taut/geometry.hpp"
#include "taut/scene.hpp"

namespace taut::internal::io {

/// Appends one JSON value to a text and puts the commas. Members keep the order in which they are written, and numbers
/// are the shortest decimals that read back as the same doubles, so that equal answers are equal bytes.
///
///     JsonWriter json;
///     json.object([&] {
///       json.member("outcome", "free");
///       json.member("t", {0.5, 0.75});
///       json.key("pairs").array(pairs, [&](const Pair& pair) { json.string(pair.name); });
///     });
class JsonWriter {
 public:
  /// `body()` writes the members.
  template <class Body>
  void object(const Body& body) {
    enclose('{', '}', body);
  }
  /// `body()` writes the items.
  template <class Body>
  void array(const Body& body) {
    enclose('[', ']', body);
  }
  /// `each(item)` writes one value for every item.
  template <class Items, class Each>
  void array(const Items& items, const Each& each) {
    array([&] {
      for (const auto& item : items) each(item);
    });
  }

  /// Begins a member of the object at hand; its value comes next.
  JsonWriter& key(std::string_view name);
  /// The same with a name that a user chose, which may need escapes.
  JsonWriter& user_key(const std::string& name);

  void string(std::string_view text);
  void number(double value);
  void count(std::uint64_t value);
  void integer(std::int64_t value);
  void boolean(bool value);
  void null();
  void numbers(std::initializer_list<double> values);
  void point(const Point& p) { numbers({p.x, p.y}); }
  /// Text that is JSON already.
  void raw(std::string_view json);

  void member(std::string_view name, std::string_view text) { key(name).string(text); }
  void member(std::string_view name, const char* text) { key(name).string(text); }
  void member(std::string_view name, std::initializer_list<double> values) { key(name).numbers(values); }
  void member(std::string_view name, const Point& p) { key(name).point(p); }
  template <class Value>
  requires std::is_arithmetic_v<Value>
  void member(std::string_view name, Value value) {
    key(name);
    if constexpr (std::is_same_v<Value, bool>) {
      boolean(value);
    } else if constexpr (std::is_floating_point_v<Value>) {
      number(value);
    } else if constexpr (std::is_unsigned_v<Value>) {
      count(value);
    } else {
      integer(value);
    }
  }

  const std::string& text() const { return text_; }

 private:
  template <class Body>
  void enclose(char open, char close, const Body& body) {
    separate();
    text_ += open;
    first_ = true;
    body();
    text_ += close;
    first_ = false;
  }
  /// A comma, unless this is the first value here or follows a key.
  void separate();

  std::string text_;
  bool first_ = true;
};

/// What `write(json)` writes.
template <class Write>
std::string json_text(const Write& write) {
  JsonWriter json;
  write(json);
  return json.text();
}

// Small pieces of JSON to write.

/// In quotes, with escapes, also of what a terminal would not show; bytes that are not UTF-8 become U+FFFD.
std::string string_text(const std::string& s);
/// [1,2.5]
std::string array_text(const std::vector<double>& numbers);
/// [x,y]
std::string point_text(const Point& p);
/// A scene's clearances: [{"pair":["a","b"],"margin":0.5},{"pair":["a","*"],"margin":[0.2,0.05],"origin":3}]
std::string clearances_text(const std::vector<PairClearance>& clearances);

}  // namespace taut::internal::io
