// The tables of the scene file: one row a key. They drive reading, writing, defaults, the schema, the docs and
// the widgets, so that a new setting is one member of Scene and one row.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/scene/reader.hpp"

namespace pf {

struct Table;

struct WriteStyle {
  int dimension = 2;
  bool defaults = true;  ///< write keys that have their default value, too
};

/// What a key's value is made of.
enum class Nesting { leaf, object, list, map };

/// One key of an object in the scene file. `owner` points to the struct that the table describes.
struct Key {
  Setting setting;  ///< its `pointer` is the key alone
  Nesting nesting = Nesting::leaf;
  std::function<const Table&()> child;  ///< of an object, of a list's or a map's items; empty: a leaf
  std::function<void(Reader&, const Json&, void* owner)> read;
  std::function<void(Reader&, void* owner)>
      absent;  ///< called instead of `read` where the key is missing; may be empty
  std::function<std::optional<Json>(const void* owner, const WriteStyle&)> write;  ///< nothing: absent
  std::function<std::optional<Json>(int dimension)> fallback;                      ///< the default; nothing: absent
  std::function<Json()> schema;        ///< where it is not what setting and child say; may be empty
  VariableMask variables = mask_none;  ///< of formulas
};

struct Table {
  std::string title;
  std::vector<Key> keys;
  const Key* find(std::string_view key) const;
  std::vector<std::string> names() const;
};

/// Reads an object by its table: unknown and missing keys are problems.
void read_table(Reader& reader, const Table& table, const Json& json, void* owner);
Json write_table(const Table& table, const void* owner, const WriteStyle& style);
/// A problem: `key` is not known here.
void refuse_unknown(Reader& reader, std::string_view key, std::span<const std::string> known);

}  // namespace pf
