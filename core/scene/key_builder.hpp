// Makes the rows of a table from members of the struct that it describes.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/scene/choices.hpp"
#include "core/scene/keys.hpp"

namespace pf {

Json to_json(const Vec3& value, int dimension);
Json to_json(const Formula& value);
/// Zeros where `value` is empty.
Json to_json(const FormulaVector& value, int dimension);

/// Says the rest of what is known of a key, in words.
class Row {
 public:
  explicit Row(Key& key) : setting_(key.setting) {}
  Row& at_least(double value) { return setting_.min = value, *this; }
  Row& above(double value) { return setting_.min = value, setting_.open_min = true, *this; }
  Row& at_most(double value) { return setting_.max = value, *this; }
  Row& below(double value) { return setting_.max = value, setting_.open_max = true, *this; }
  Row& within(double size) { return setting_.min = -size, setting_.max = size, *this; }
  Row& slider(double from, double to) { return setting_.slider_min = from, setting_.slider_max = to, *this; }
  Row& log_slider(double from, double to) { return setting_.logarithmic = true, slider(from, to); }
  Row& choices(std::vector<std::string> names) { return setting_.choices = std::move(names), *this; }
  Row& choices(std::span<const Choice> table) { return choices(names(table)); }
  Row& required() { return setting_.required = true, *this; }
  Row& live() { return setting_.applies = Applies::live, *this; }
  Row& reset() { return setting_.applies = Applies::reset, *this; }
  Row& view() { return setting_.applies = Applies::view, *this; }
  Row& help(std::string text) { return setting_.help = std::move(text), *this; }

 private:
  Setting& setting_;
};

/// The rows for struct T, whose default values are the scene file's.
template <class T>
class TableOf {
 public:
  using Read = std::function<bool(Reader&, const Json&, const Setting&, T&)>;
  using Write = std::function<std::optional<Json>(const T&, const WriteStyle&)>;

  explicit TableOf(std::string title) { table_.title = std::move(title); }

  /// A leaf that is read and written in a way of its own.
  Row leaf(SettingKind kind, std::string key, std::string label, std::string unit, Read read, Write write) {
    Key& row = add(std::move(key), std::move(label), std::move(unit), kind);
    const std::size_t index = table_.keys.size() - 1;
    settings_of_.push_back(index);
    pending_.push_back(std::move(read));
    row.write = [write](const void* owner, const WriteStyle& style) {
      return write(*static_cast<const T*>(owner), style);
    };
    row.fallback = [write](int dimension) { return write(T{}, {dimension, true}); };
    return Row(row);
  }

  Row number(double T::*member, std::string key, std::string label, std::string unit) {
    return leaf(
        SettingKind::number, std::move(key), std::move(label), std::move(unit),
        [member](Reader& r, const Json& j, const Setting& s, T& o) { return read_number(r, j, s, o.*member); },
        [member](const T& o, const WriteStyle&) { return Json(o.*member); });
  }
  Row number(std::optional<double> T::*member, std::string key, std::string label, std::string unit) {
    return leaf(
        SettingKind::number, std::move(key), std::move(label), std::move(unit),
        [member](Reader& r, const Json& j, const Setting& s, T& o) {
          double value = 0;
          const bool good = read_number(r, j, s, value);
          if (good) o.*member = value;
          return good;
        },
        [member](const T& o, const WriteStyle&) {
          return o.*member ? std::optional<Json>(*(o.*member)) : std::nullopt;
        });
  }
  template <class Integer>
  Row integer(Integer T::*member, std::string key, std::string label) {
    return leaf(
        SettingKind::integer, std::move(key), std::move(label), "",
        [member](Reader& r, const Json& j, const Setting& s, T& o) {
          std::uint64_t value = 0;
          const bool good = read_integer(r, j, s, value);
          if (good) o.*member = static_cast<Integer>(value);
          return good;
        },
        [member](const T& o, const WriteStyle&) { return Json(o.*member); });
  }
  Row text(std::string T::*member, std::string key, std::string label) {
    return leaf(
        SettingKind::text, std::move(key), std::move(label), "",
        [member](Reader& r, const Json& j, const Setting& s, T& o) { return read_text(r, j, s, o.*member); },
        [member](const T& o, const WriteStyle&) { return Json(o.*member); });
  }
  Row flag(bool T::*member, std::string key, std::string label) {
    return leaf(
        SettingKind::flag, std::move(key), std::move(label), "",
        [member](Reader& r, const Json& j, const Setting&, T& o) { return read_flag(r, j, o.*member); },
        [member](const T& o, const WriteStyle&) { return Json(o.*member); });
  }
  Row choice(std::string T::*member, std::string key, std::string label) {
    return leaf(
        SettingKind::choice, std::move(key), std::move(label), "",
        [member](Reader& r, const Json& j, const Setting& s, T& o) { return read_choice(r, j, s, o.*member); },
        [member](const T& o, const WriteStyle&) { return Json(o.*member); });
  }
  Row vector(Vec3 T::*member, std::string key, std::string label, std::string unit) {
    return leaf(
        SettingKind::vector, std::move(key), std::move(label), std::move(unit),
        [member](Reader& r, const Json& j, const Setting& s, T& o) { return read_vector(r, j, s, o.*member); },
        [member](const T& o, const WriteStyle& style) { return to_json(o.*member, style.dimension); });
  }
  Row flags(std::vector<bool> T::*member, std::string key, std::string label) {
    return leaf(
        SettingKind::flag_vector, std::move(key), std::move(label), "",
        [member](Reader& r, const Json& j, const Setting& s, T& o) { return read_flags(r, j, s, o.*member); },
        [member](const T& o, const WriteStyle&) { return Json(o.*member); });
  }
  /// One formula a component; zeros by default, or none where `optional`.
  Row formulas(FormulaVector T::*member, VariableMask mask, bool optional, std::string key, std::string label,
               std::string unit) {
    const Row row = leaf(
        SettingKind::formula_vector, std::move(key), std::move(label), std::move(unit),
        [member, mask](Reader& r, const Json& j, const Setting& s, T& o) {
          return read_formulas(r, j, s, mask, o.*member);
        },
        [member, optional](const T& o, const WriteStyle& style) {
          if (optional && (o.*member).empty()) return std::optional<Json>();
          return std::optional<Json>(to_json(o.*member, style.dimension));
        });
    table_.keys.back().variables = mask;
    if (!optional) {
      table_.keys.back().absent = [member](Reader& r, void* owner) {
        (static_cast<T*>(owner)->*member).assign(static_cast<std::size_t>(r.dimension()), Formula{});
      };
    }
    return row;
  }

  /// An object whose keys `child` lists.
  template <class Child>
  Row object(Child T::*member, const Table& (*child)(), std::string key, std::string label) {
    Key& row = add(std::move(key), std::move(label), "", SettingKind::text);
    row.nesting = Nesting::object;
    row.child = child;
    row.read = [member, child](Reader& r, const Json& j, void* o) {
      read_table(r, child(), j, &(static_cast<T*>(o)->*member));
    };
    row.write = [member, child](const void* o, const WriteStyle& style) {
      return write_table(child(), &(static_cast<const T*>(o)->*member), style);
    };
    row.fallback = [](int) { return Json::object(); };
    return Row(row);
  }

  /// An array of `least` to `most` objects.
  template <class Item>
  Row list(std::vector<Item> T::*member, const Table& (*child)(), std::size_t least, std::size_t most, std::string key,
           std::string label) {
    Key& row = add(key, std::move(label), "", SettingKind::text);
    row.nesting = Nesting::list;
    row.child = child;
    row.setting.min = static_cast<double>(least);
    row.setting.max = static_cast<double>(most);
    row.read = [=](Reader& r, const Json& j, void* o) {
      if (!j.is_array()) return r.refuse(describe(j), "an array [ ... ] of objects");
      if (j.size() < least) return r.refuse(describe(j), std::to_string(least) + " or more");
      if (!check_count(r, j.size(), most, key)) return;
      auto& items = static_cast<T*>(o)->*member;
      items.resize(j.size());
      for (std::size_t k = 0; k < j.size(); ++k) {
        const Reader::Step step(r, k);
        read_table(r, child(), j[k], &items[k]);
      }
    };
    row.write = [=](const void* o, const WriteStyle& style) {
      Json array = Json::array();
      for (const Item& item : static_cast<const T*>(o)->*member) array.push_back(write_table(child(), &item, style));
      return array;
    };
    row.fallback = [](int) { return Json::array(); };
    return Row(row);
  }

  /// A key that is read and written in a way of its own; `child` describes it.
  Key& own(Nesting nesting, const Table& (*child)(), std::string key, std::string label) {
    Key& row = add(std::move(key), std::move(label), "", SettingKind::text);
    row.nesting = nesting;
    if (child) row.child = child;
    row.fallback = [nesting](int) { return nesting == Nesting::list ? Json::array() : Json::object(); };
    return row;
  }

  /// The row that was added last.
  Key& last() { return table_.keys.back(); }

  /// The finished table: what the rows say of ranges and choices goes into their readers.
  Table take() {
    for (std::size_t k = 0; k < pending_.size(); ++k) {
      Key& row = table_.keys[settings_of_[k]];
      row.read = [read = pending_[k], setting = row.setting](Reader& reader, const Json& json, void* owner) {
        read(reader, json, setting, *static_cast<T*>(owner));
      };
    }
    for (Key& row : table_.keys) {
      if (row.setting.required) row.fallback = [](int) { return std::nullopt; };
    }
    return std::move(table_);
  }

 private:
  Key& add(std::string key, std::string label, std::string unit, SettingKind kind) {
    table_.keys.emplace_back();
    Setting& setting = table_.keys.back().setting;
    setting.pointer = std::move(key);
    setting.label = std::move(label);
    setting.unit = std::move(unit);
    setting.kind = kind;
    return table_.keys.back();
  }

  Table table_;
  std::vector<std::size_t> settings_of_;  ///< row of each pending reader
  std::vector<Read> pending_;
};

}  // namespace pf
