#pragma once

#include "core/error.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace blockfsi::run
{

/// How a signal becomes a number.
enum class Statistic
{
  last,       ///< the last sample
  steady,     ///< the last sample of a signal that has stopped to change
  greatest,   ///< greatest value of the whole run, between samples by a parabola
  least,      ///< least value of the whole run
  maximum,    ///< greatest value in the last periods
  minimum,    ///< least value in the last periods
  mean,       ///< (maximum + minimum) / 2
  amplitude,  ///< (maximum - minimum) / 2
  frequency   ///< periods per second [Hz]
};

/// How far from the reference a computed value may be.
enum class Kind
{
  relative,  ///< by tolerance times the reference
  absolute,  ///< by the tolerance
  at_least,  ///< nowhere below
  at_most    ///< nowhere above
};

/// A row of reference.csv: a number that a case must reproduce.
struct Reference
{
  std::string quantity;  ///< column of a table, or a formula in such columns: "front_p - back_p"
  Statistic statistic = Statistic::last;
  int periods = 1;      ///< over how many of the last periods extrema are averaged: 5 in "amplitude5"
  std::string clock;    ///< column or formula whose periods count; empty: the quantity itself
  double factor = 1.0;  ///< multiplies the statistic
  double value = 0.0;
  double tolerance = 0.0;
  Kind kind = Kind::relative;
  bool in_short = false;  ///< whether the short form of the case is held to it
  bool in_full = false;   ///< whether the full form is
  std::string source;
  Location where;
};

/// Reads a table of references: CSV with the columns quantity, statistic, clock, factor, value, tolerance,
/// kind, level (short, full or both) and source in any order. Fields with commas stand in double quotes.
/// Empty are allowed: clock, factor (1), source and, for the kinds "at least" and "at most", the tolerance.
/// Throws Error with the place of the first mistake.
std::vector<Reference> read_references(const std::filesystem::path& path);

/// The statistic as reference.csv writes it: "amplitude5".
std::string statistic_name(const Reference& reference);

}  // namespace blockfsi::run
