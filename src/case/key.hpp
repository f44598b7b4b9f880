#pragma once

#include "case/tree.hpp"
#include "case/value.hpp"
#include "core/nearest.hpp"
#include "geometry/cad.hpp"
#include "geometry/level_set.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace blockfsi::case_file
{

/// Largest number of cells along an edge that a file may ask for.
inline constexpr int most_cells = 100000;

/// A formula of a field, with the place where it must have a finite value.
struct Sample
{
  Expression expression;
  Location where;
  std::string path;
  std::string name;          ///< of the boundary or the region
  bool on_boundary = false;  ///< at the nodes of a boundary, else at the corners of a region's blocks
};

/// What the reading of one section may need from those before it.
struct Reading
{
  Constants constants;
  std::vector<std::string> boundaries;  ///< names in [boundaries]
  std::vector<Sample> samples;
  std::map<std::string, geometry::LevelSet> level_sets;  ///< of [geometry], as far as they are read
  std::map<std::string, geometry::CadFile> cad_files;    ///< by path, as far as they are read
  const Value* geometry = nullptr;                       ///< the section [geometry]
  std::vector<std::string> unfinished;  ///< names in [geometry] that are being read, each for the one before
};

/// A key as `describe` shows it.
struct Description
{
  std::string name;
  std::string type;
  std::string fallback;  ///< the default; "required" makes the key compulsory
  std::string unit;
  std::string meaning;
};

/// A group of keys as `describe` shows it.
struct Section
{
  std::string title;
  std::string meaning;
  std::vector<Description> keys;
};

/// The one declaration of a key: what it says and how it is read into a T.
template <typename T>
struct Key
{
  Description says;
  void (*read)(const Value& value, Reading& reading, T& target);
};

template <typename T>
using Keys = std::vector<Key<T>>;

template <typename T>
std::vector<std::string> names(const Keys<T>& keys)
{
  std::vector<std::string> result;
  for (const Key<T>& key : keys)
    result.push_back(key.says.name);
  return result;
}

template <typename T>
Section section(std::string title, std::string meaning, const Keys<T>& keys)
{
  Section result{std::move(title), std::move(meaning), {}};
  for (const Key<T>& key : keys)
    result.keys.push_back(key.says);
  return result;
}

/// Throws Error that a key is unknown, with the nearest known name or all of them.
[[noreturn]] void unknown_key(const Field& field, const std::vector<std::string>& known);

/// Throws Error that a key is missing in a table.
[[noreturn]] void missing_key(const Value& table, const Description& key);

/// Reads the fields of a table by the declarations of its keys. Fields that none declares go to `other` with
/// the field; it returns false if it does not know the name either.
template <typename T, typename Other>
void read_keys(const Value& value, const Keys<T>& keys, Reading& reading, T& target, const Other& other)
{
  for (const Field& field : table(value))
  {
    const auto key = std::find_if(keys.begin(), keys.end(),
                                  [&](const Key<T>& candidate) { return candidate.says.name == field.name; });
    if (key != keys.end())
      key->read(field.value, reading, target);
    else
      other(field);
  }
  for (const Key<T>& key : keys)
    if (key.says.fallback == "required" && !value.find(key.says.name))
      missing_key(value, key.says);
}

/// The same where no other fields are allowed.
template <typename T>
void read_keys(const Value& value, const Keys<T>& keys, Reading& reading, T& target)
{
  read_keys(value, keys, reading, target, [&](const Field& field) { unknown_key(field, names(keys)); });
}

/// Reads a table with exactly one of some keys, as in { velocity = [...] }.
template <typename T>
void read_one(const Value& value, const Keys<T>& keys, Reading& reading, T& target)
{
  const auto* fields = std::get_if<Value::Table>(&value.content);
  if (!fields)
    fail(value, "found " + found(value) + ", allowed is a table with one of " + listed(names(keys)));
  if (fields->size() != 1)
    fail(value, "found " + std::to_string(fields->size()) + " keys, allowed is exactly one of " +
                    listed(names(keys)));
  read_keys(value, keys, reading, target);
}

}  // namespace blockfsi::case_file
