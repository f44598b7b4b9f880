#include "block/round.hpp"

#include "case/edge.hpp"
#include "case/level_set.hpp"
#include "case/pieces.hpp"

#include <fmt/format.h>

#include <array>

namespace blockfsi::case_file
{

namespace
{

/// Keys that pieces share.
template <typename T>
Key<T> region_key()
{
  return {{"region", "text", "required", "", "region that the blocks belong to"},
          [](const Value& v, Reading&, T& t) { t.region = text(v); }};
}
template <typename T>
Key<T> center_key()
{
  return {{"center", "list of numbers", "the origin", "m", "the centre"},
          [](const Value& v, Reading& r, T& t) { t.center = point_in_space(v, r.constants); }};
}
template <typename T>
Key<T> radius_key()
{
  return {{"radius", "number", "required", "m", "the radius"},
          [](const Value& v, Reading& r, T& t) { t.radius = number(v, r.constants, positive); }};
}
template <typename T>
Key<T> radii_key()
{
  return {
      {"radii", "[number, number]", "required", "m", "inner and outer radius"},
      [](const Value& v, Reading& r, T& t)
      {
        if (list(v).size() != 2)
          fail(v, fmt::format("found {}, allowed are two numbers, the inner and the outer radius", found(v)));
        for (std::size_t i = 0; i < 2; ++i)
          t.radii[i] = number(list(v)[i], r.constants, positive);
      }};
}
template <typename T>
Key<T> core_key()
{
  return {{"core", "number", "0.5", "-", "distance of the core's corners from the centre over the radius"},
          [](const Value& v, Reading& r, T& t)
          {
            t.core = number(v, r.constants,
                            {.low = 0,
                             .high = 1,
                             .low_allowed = false,
                             .high_allowed = false,
                             .words = "a number between 0 and 1"});
          }};
}
template <typename T>
Key<T> around_key(const char* meaning)
{
  return {{"around", "whole number", fmt::format("{}", T{}.around), "", meaning},
          [](const Value& v, Reading& r, T& t) { t.around = integer(v, r.constants, 1, most_cells); }};
}
template <typename T>
Key<T> radial_key(const char* meaning)
{
  return {{"radial", "whole number", fmt::format("{}", T{}.radial), "", meaning},
          [](const Value& v, Reading& r, T& t) { t.radial = integer(v, r.constants, 1, most_cells); }};
}
template <typename T>
Key<T> grade_key(const char* meaning)
{
  return {{"grade", "grading", "uniform", "", meaning},
          [](const Value& v, Reading& r, T& t) { t.grading = read_grading(v, r); }};
}

const Keys<block::Box>& box_keys()
{
  using T = block::Box;
  static const Keys<T> keys = {
      region_key<T>(),
      {{"from", "list of numbers", "the origin", "m", "lowest corner"},
       [](const Value& v, Reading& r, T& t) { t.from = point_in_space(v, r.constants); }},
      {{"to", "list of numbers", "required", "m", "highest corner"},
       [](const Value& v, Reading& r, T& t) { t.to = point_in_space(v, r.constants); }},
      {{"divide", "list of whole numbers", "1 each", "", "cells along x, y and z"},
       [](const Value& v, Reading& r, T& t)
       {
         if (list(v).empty() || list(v).size() > 3)
           fail(v, fmt::format("found {}, allowed is one whole number per direction", found(v)));
         for (std::size_t i = 0; i < list(v).size(); ++i)
           t.divisions[i] = integer(list(v)[i], r.constants, 1, most_cells);
       }},
      {{"grade", "list of gradings", "uniform", "", "of the cells along x, y and z"},
       [](const Value& v, Reading& r, T& t)
       {
         if (list(v).empty() || list(v).size() > 3)
           fail(v, fmt::format("found {}, allowed is one grading per direction", found(v)));
         for (std::size_t i = 0; i < list(v).size(); ++i)
           t.gradings[i] = read_grading(list(v)[i], r);
       }}};
  return keys;
}

const Keys<block::Disc>& disc_keys()
{
  using T = block::Disc;
  static const Keys<T> keys = {region_key<T>(),
                               center_key<T>(),
                               radius_key<T>(),
                               core_key<T>(),
                               around_key<T>("cells along each side of the square in the middle"),
                               radial_key<T>("cells between the square and the circle"),
                               grade_key<T>("of these cells, towards the circle")};
  return keys;
}

const Keys<block::Annulus>& annulus_keys()
{
  using T = block::Annulus;
  static const Keys<T> keys = {region_key<T>(),
                               center_key<T>(),
                               radii_key<T>(),
                               {{"from", "number", "0", "degrees", "where it starts, against the x axis"},
                                [](const Value& v, Reading& r, T& t) { t.from = number(v, r.constants); }},
                               {{"to", "number", "360", "degrees", "where it ends"},
                                [](const Value& v, Reading& r, T& t) { t.to = number(v, r.constants); }},
                               {{"sectors", "whole number", "4", "", "blocks around"},
                                [](const Value& v, Reading& r, T& t)
                                { t.sectors = integer(v, r.constants, 1, most_cells); }},
                               around_key<T>("cells along each of them"),
                               radial_key<T>("cells between the circles"),
                               grade_key<T>("of these cells, towards the outer circle")};
  return keys;
}

constexpr std::array<std::string_view, 2> obstacles = {"round", "square"};
constexpr std::array<std::string_view, 2> grids = {"ring", "wake"};

const Keys<block::Channel>& channel_keys()
{
  using T = block::Channel;
  static const Keys<T> keys = {
      region_key<T>(),
      {{"length", "number", "required", "m", "of the channel, from x = 0"},
       [](const Value& v, Reading& r, T& t) { t.length = number(v, r.constants, positive); }},
      {{"height", "number", "required", "m", "of the channel, from y = 0"},
       [](const Value& v, Reading& r, T& t) { t.height = number(v, r.constants, positive); }},
      {{"center", "[number, number]", "required", "m", "centre of the obstacle"},
       [](const Value& v, Reading& r, T& t)
       {
         const auto x = point_in_space(v, r.constants);
         t.center = {x[0], x[1]};
       }},
      {{"size", "number", "required", "m", "diameter of a round obstacle, side of a square one"},
       [](const Value& v, Reading& r, T& t) { t.size = number(v, r.constants, positive); }},
      {{"box", "number", "required", "m", "side of the box of finer blocks around the obstacle"},
       [](const Value& v, Reading& r, T& t) { t.box = number(v, r.constants, positive); }},
      {{"obstacle", "\"round\" or \"square\"", "round", "", "what the channel goes round"},
       [](const Value& v, Reading&, T& t)
       { t.obstacle = static_cast<block::Obstacle>(choice(v, obstacles)); }},
      {{"grid", "\"ring\" or \"wake\"", "ring", "",
        "blocks all round (O) or round the front and on downstream beside a wake (C)"},
       [](const Value& v, Reading&, T& t) { t.grid = static_cast<block::ObstacleGrid>(choice(v, grids)); }},
      around_key<T>("cells along each quarter of the obstacle"),
      radial_key<T>("cells between the obstacle and the box"),
      grade_key<T>("of these cells, away from the obstacle"),
      {{"outside", "list of four whole numbers", "[4, 8, 4, 4]", "",
        "cells before, behind, below and above the box"},
       [](const Value& v, Reading& r, T& t)
       {
         if (list(v).size() != 4)
           fail(v, fmt::format(
                       "found {}, allowed are four whole numbers: before, behind, below and above the box",
                       found(v)));
         for (std::size_t i = 0; i < 4; ++i)
           t.outside[i] = integer(list(v)[i], r.constants, 1, most_cells);
       }}};
  return keys;
}

const Keys<block::Ball>& ball_keys()
{
  using T = block::Ball;
  static const Keys<T> keys = {region_key<T>(),
                               center_key<T>(),
                               radius_key<T>(),
                               core_key<T>(),
                               around_key<T>("cells along each edge of the cube in the middle"),
                               radial_key<T>("cells between the cube and the sphere"),
                               grade_key<T>("of these cells, towards the sphere")};
  return keys;
}

const Keys<block::Shell>& shell_keys()
{
  using T = block::Shell;
  static const Keys<T> keys = {region_key<T>(),
                               center_key<T>(),
                               radii_key<T>(),
                               around_key<T>("cells along each edge of the six blocks on a sphere"),
                               radial_key<T>("cells between the spheres"),
                               grade_key<T>("of these cells, towards the outer sphere")};
  return keys;
}

template <typename T, const Keys<T>& (*keys)()>
void read_piece(const Field& field, Reading& reading, Pieces&, block::Layout& layout)
{
  T piece;
  piece.name = field.name;
  piece.where = field.where;
  read_keys(field.value, keys(), reading, piece);
  block::add(layout, piece);
}

}  // namespace

std::span<const PieceKind> round_kinds()
{
  static const std::array<PieceKind, 6> kinds = {
      {{{"box", "tables NAME", "", "", "rectangles, in 3D cuboids"},
        read_piece<block::Box, box_keys>,
        []
        {
          return std::vector<Section>{
              section("[blocks.box.NAME]", "one block; boundaries \"NAME x0\", \"NAME x1\", \"NAME y0\", ...",
                      box_keys())};
        }},
       {{"disc", "tables NAME", "", "", "discs with an O-grid"},
        read_piece<block::Disc, disc_keys>,
        []
        {
          return std::vector<Section>{
              section("[blocks.disc.NAME]", "five blocks; boundary \"NAME wall\"", disc_keys())};
        }},
       {{"annulus", "tables NAME", "", "", "rings and parts of rings"},
        read_piece<block::Annulus, annulus_keys>,
        []
        {
          return std::vector<Section>{
              section("[blocks.annulus.NAME]",
                      "boundaries \"NAME inner\", \"NAME outer\", of a part also \"NAME "
                      "start\", \"NAME end\"",
                      annulus_keys())};
        }},
       {{"channel", "tables NAME", "", "", "channels with an obstacle"},
        read_piece<block::Channel, channel_keys>,
        []
        {
          return std::vector<Section>{section(
              "[blocks.channel.NAME]",
              "boundaries \"NAME inlet\", \"NAME outlet\", \"NAME bottom\", \"NAME top\", \"NAME obstacle\"",
              channel_keys())};
        }},
       {{"ball", "tables NAME", "", "", "balls with an O-grid"},
        read_piece<block::Ball, ball_keys>,
        []
        {
          return std::vector<Section>{
              section("[blocks.ball.NAME]", "seven blocks; boundary \"NAME wall\"", ball_keys())};
        }},
       {{"shell", "tables NAME", "", "", "spherical shells"},
        read_piece<block::Shell, shell_keys>,
        []
        {
          return std::vector<Section>{section(
              "[blocks.shell.NAME]", "six blocks; boundaries \"NAME inner\", \"NAME outer\"", shell_keys())};
        }}}};
  return kinds;
}

}  // namespace blockfsi::case_file
