#include "core/scene/keys.hpp"

#include "core/params/json_text.hpp"
#include "core/params/nearest.hpp"
#include "core/params/setting_text.hpp"

namespace pf {

const Key* Table::find(std::string_view key) const {
  for (const Key& candidate : keys) {
    if (candidate.setting.pointer == key) return &candidate;
  }
  return nullptr;
}

std::vector<std::string> Table::names() const {
  std::vector<std::string> result;
  for (const Key& key : keys) result.push_back(key.setting.pointer);
  return result;
}

void refuse_unknown(Reader& reader, std::string_view key, std::span<const std::string> known) {
  const Reader::Step step(reader, key);
  reader.refuse("the unknown key " + quoted_excerpt(key), suggest(key, known));
}

void read_table(Reader& reader, const Table& table, const Json& json, void* owner) {
  if (!json.is_object()) {
    reader.refuse(describe(json), "an object { ... } with " + suggest("", table.names()));
    return;
  }
  for (const auto& [name, value] : json.items()) {
    const Key* key = table.find(name);
    if (!key) {
      refuse_unknown(reader, name, table.names());
      continue;
    }
    const Reader::Step step(reader, name);
    key->read(reader, value, owner);
  }
  for (const Key& key : table.keys) {
    if (json.contains(key.setting.pointer)) continue;
    if (key.absent) key.absent(reader, owner);
    if (!key.setting.required) continue;
    const Reader::Step step(reader, key.setting.pointer);
    const char* const nested = key.nesting == Nesting::list ? "an array [ ... ]" : "an object { ... }";
    const std::string what = key.nesting == Nesting::leaf ? allowed_text(key.setting, reader.dimension()) : nested;
    reader.refuse("nothing", what + "; this key is required");
  }
}

Json write_table(const Table& table, const void* owner, const WriteStyle& style) {
  Json object = Json::object();
  for (const Key& key : table.keys) {
    std::optional<Json> value = key.write(owner, style);
    if (!value) continue;
    if (!style.defaults && !key.setting.required) {
      if (key.nesting == Nesting::leaf ? value == key.fallback(style.dimension) : value->empty()) continue;
    }
    object[key.setting.pointer] = *std::move(value);
  }
  return object;
}

}  // namespace pf
