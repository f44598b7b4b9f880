#include "case/case.hpp"

#include "core/error.hpp"
#include "geometry/cad.hpp"
#include "geometry/curve.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

using namespace blockfsi;

namespace
{

const std::filesystem::path folder = std::filesystem::path(BLOCKFSI_TESTS_FOLDER) / "unit" / "case";
const std::filesystem::path wall_ramm = folder / "wall_ramm.toml";
const std::filesystem::path everything = folder / "everything.toml";

std::string complaint(const std::filesystem::path& file, const std::vector<std::string>& overrides)
{
  try
  {
    case_file::read(file, overrides);
  }
  catch (const Error& error)
  {
    return error.what();
  }
  return "accepted";
}

const block::Point& point(const case_file::Case& read, int index)
{
  return read.layout.points[index];
}

}  // namespace

TEST_CASE("the Wall-Ramm benchmark is read as it is written")
{
  const case_file::Case read = case_file::read(wall_ramm);
  CHECK(read.title == "Flap behind a square block (Wall & Ramm 1998, variant A)");
  CHECK(read.constants.at("U") == 0.513);
  CHECK(read.layout.order == 3);
  CHECK(read.layout.blocks.size() == 17);
  CHECK(read.layout.points.size() == 30);
  CHECK(read.layout.boundaries.size() == 4);
  REQUIRE(read.layout.grade_towards.size() == 1);
  CHECK(read.layout.grade_towards[0].names == std::vector<std::string>{"square", "flap"});
  CHECK(read.layout.grade_towards[0].first == 4e-4);

  REQUIRE(read.fluid.has_value());
  CHECK(read.fluid->density == 1.18);
  CHECK(read.fluid->viscosity == 1.82e-5);
  REQUIRE(read.fluid->boundaries.size() == 4);
  CHECK(read.fluid->boundaries[0].boundary == "inlet");
  const auto& inlet = std::get<fluid::Velocity>(read.fluid->boundaries[0].condition);
  CHECK(inlet.value[0](0.0, 0.0, 0.0, 0.5) == doctest::Approx(0.513 / 2));
  CHECK(std::holds_alternative<fluid::Traction>(read.fluid->boundaries[1].condition));
  CHECK(std::holds_alternative<fluid::Slip>(read.fluid->boundaries[2].condition));
  CHECK(std::holds_alternative<fluid::Wall>(read.fluid->boundaries[3].condition));

  REQUIRE(read.solid.has_value());
  CHECK(read.solid->region == "flap");
  CHECK(read.solid->young == 2.5e5);
  CHECK(read.solid->poisson == 0.35);
  CHECK(read.solid->plane == solid::Plane::strain);
  CHECK(std::holds_alternative<solid::Fixed>(read.solid->boundaries.at(0).condition));

  CHECK(read.time.scheme == fem::Scheme::crank_nicolson);
  CHECK(read.time.end == 10.0);
  CHECK(read.time.step == 2.5e-3);
  CHECK(read.output.every == 0.02);
  CHECK(read.output.probes.at(0).name == "tip");
  CHECK(read.output.probes.at(0).of == "displacement");
  CHECK(read.output.forces.size() == 2);
}

TEST_CASE("rules name points with or without their lattice and with weights")
{
  const case_file::Case read = case_file::read(wall_ramm);
  REQUIRE(read.motion.corners.follows.size() == 2);
  CHECK(point(read, read.motion.corners.follows[0].point).name == "channel x3 y1");
  CHECK(point(read, read.motion.corners.follows[0].leaders.at(0).point).name == "channel x3 y2");
  CHECK(point(read, read.motion.corners.follows[1].point).name == "channel x3 y4");
  CHECK(read.motion.corners.follows[1].leaders.at(0).weight == 1.0);
}

TEST_CASE("corners slide along walls and slip unless the case says otherwise")
{
  const auto corners = [](const std::vector<std::string>& overrides)
  { return case_file::read(wall_ramm, overrides).motion.corners; };
  CHECK(corners({}).rule == block::CornerRule::automatic);
  CHECK(corners({}).slide.value() == std::vector<std::string>{"sides", "square"});
  const block::CornerParameters chosen =
      corners({R"(motion.regenerate={ corners = "nonlinear", slide = ["inlet"] })"});
  CHECK(chosen.rule == block::CornerRule::nonlinear);
  CHECK(chosen.slide.value() == std::vector<std::string>{"inlet"});
  CHECK(corners({R"(motion.regenerate={ corners = "radial", slide = [] })"}).slide->empty());
  CHECK(corners({R"(motion.regenerate={ corners = "radial" })"}).rule == block::CornerRule::radial);
  CHECK(corners({R"(motion.regenerate={ corners = "elastic" })"}).rule == block::CornerRule::elastic);
  CHECK(corners({R"(motion.regenerate={ corners = "fixed" })"}).rule == block::CornerRule::fixed);
}

TEST_CASE("a name that a merge takes away still finds its point")
{
  const case_file::Case read = case_file::read(
      everything, {"blocks.points.twin=[2, 0.5]",
                   R"(blocks.quads.tail={ corners = ["twin", "p", "q", "box x3 y0"], region = "fluid" })",
                   R"(motion.regenerate={ follows = { "twin" = "box x2 y1" } })"});
  REQUIRE(read.motion.corners.follows.size() == 1);
  CHECK(point(read, read.motion.corners.follows[0].point).name == "box x3 y1");
}

TEST_CASE("pieces that coincide are merged")
{
  const case_file::Case read = case_file::read(everything);
  // 12 points of the box, 16 of the ring, 2 more of the quadrilateral.
  CHECK(read.layout.points.size() == 30);
  CHECK(read.layout.blocks.size() == 15);
}

TEST_CASE("every key reaches its parameter")
{
  const case_file::Case read = case_file::read(everything);
  CHECK(read.constants.at("double") == 1.0);
  CHECK(read.layout.default_divisions == 2);
  CHECK(read.layout.grade_towards.size() == 2);
  CHECK(read.fluid->viscosity == 0.01);
  CHECK(read.fluid->body_force[1](0, 0, 0, 1.0) == -9.81);
  CHECK(read.fluid->initial_velocity[0](0.0, 2.0) == 1.0);
  CHECK(read.fluid->backflow == 0.4);
  CHECK(read.fluid->stabilisation_time == 5e-3);
  CHECK(read.fluid->newton.tolerance == 1e-9);
  CHECK(read.fluid->newton.iterations == 12);
  CHECK(std::get<fluid::Outflow>(read.fluid->boundaries.at(1).condition).pressure(0.0) == 1.0);
  CHECK(std::get<fluid::Traction>(read.fluid->boundaries.at(3).condition).value[1](0.0) == 1.0);
  CHECK(read.solid->plane == solid::Plane::stress);
  CHECK(read.solid->load_steps == 4);
  CHECK(read.solid->newton.iterations == 9);
  CHECK(read.time.scheme == fem::Scheme::backward_euler);
  CHECK(read.time.start_up == 3);
  CHECK(read.time.ringing_decay == 0.02);
  CHECK(read.solid->order == 3);
  CHECK(read.solid->divide == 1.0);
  CHECK(read.solid->initial_velocity[1](0.0, 0.0, 0.0, 0.0) == 0.5);
  CHECK(read.solid_differs());
  CHECK(read.solid_layout().order == 3);
  const auto& accelerator = std::get<coupling::IqnIls>(read.coupling.accelerator);
  CHECK(accelerator.reuse == 4);
  CHECK(accelerator.filter == 0.1);
  CHECK(accelerator.initial == 0.3);
  CHECK(read.coupling.tolerance == 1e-6);
  CHECK(read.coupling.iterations == 30);
  CHECK(read.coupling.predictor == 1);
  CHECK(read.output.directory == "somewhere");
  CHECK(read.output.checkpoint_every == 7);
  CHECK(read.output.forces.at(0).on == std::vector<std::string>{"stone", "flap"});
  CHECK(read.petsc_options == "-ksp_type gmres");
}

TEST_CASE("an override replaces one value and leaves the others")
{
  const case_file::Case read =
      case_file::read(wall_ramm, {"time.end=0.1", "blocks.order=4", "fluid.inlet={ wall = true }"});
  CHECK(read.time.end == 0.1);
  CHECK(read.time.step == 2.5e-3);
  CHECK(read.layout.order == 4);
  CHECK(std::holds_alternative<fluid::Wall>(read.fluid->boundaries[0].condition));
}

TEST_CASE("an override may add a section")
{
  const case_file::Case read =
      case_file::read(wall_ramm, {"coupling.accelerator={ aitken = { initial = 0.2 } }"});
  CHECK(std::get<coupling::Aitken>(read.coupling.accelerator).initial == 0.2);
}

TEST_CASE("the predictor is an order, or automatic, which is the default")
{
  CHECK(case_file::read(wall_ramm, {"coupling.predictor=5"}).coupling.predictor == 5);
  CHECK_FALSE(
      case_file::read(wall_ramm, {"coupling.predictor=\"automatic\""}).coupling.predictor.has_value());
  CHECK_FALSE(case_file::read(wall_ramm).coupling.predictor.has_value());
  CHECK(complaint(wall_ramm, {"coupling.predictor=6"}) ==
        "--set: [coupling] predictor: found 6, allowed is a whole number from 0 to 5");
  CHECK(
      complaint(wall_ramm, {"coupling.predictor=\"best\""}) ==
      "--set: [coupling] predictor: found \"best\", allowed is \"automatic\" or a whole number from 0 to 5");
}

TEST_CASE("mistakes in overrides are told as such")
{
  CHECK(complaint(wall_ramm, {"time.end=-1"}) == "--set: [time] end: found -1, allowed is a number > 0");
  CHECK(complaint(wall_ramm, {"time.ent=1"}) == "--set: [time] ent: unknown key; did you mean 'end'?");
  CHECK(complaint(wall_ramm, {"time.scheme=steady"})
            .find("--set: found 'time.scheme=steady', allowed is an assignment "
                  "key.path=value in TOML syntax") == 0);
  CHECK(complaint(wall_ramm, {"time.end"}).find("--set: found 'time.end', allowed is an assignment") == 0);
}

TEST_CASE("a case without fluid and solid is a mesh and needs neither time nor conditions")
{
  const case_file::Case read = case_file::read(folder / "mesh_only.toml");
  CHECK_FALSE(read.fluid.has_value());
  CHECK_FALSE(read.solid.has_value());
  CHECK(read.layout.blocks.size() == 8);
}

TEST_CASE("a fluid alone may be enclosed")
{
  CHECK(complaint(folder / "cavity.toml", {}) == "accepted");
}

TEST_CASE("a steady case needs no times")
{
  CHECK(complaint(folder / "cavity.toml", {"time={ scheme = \"steady\" }"}) == "accepted");
}

TEST_CASE("a file that does not exist is named")
{
  CHECK(complaint("no/such/case.toml", {}) ==
        "no/such/case.toml: cannot be read; give the path of a case file in TOML format");
}

TEST_CASE("ways of moving the mesh are read with their stiffness")
{
  const case_file::Case read = case_file::read(everything);
  REQUIRE(read.variants.size() == 3);
  CHECK(std::holds_alternative<motion::Regeneration>(read.motion.update));
  CHECK(read.variants[0].first == "solid");
  const auto& solid = std::get<motion::PseudoSolid>(read.variants[0].second.update);
  CHECK(solid.stiffness.base == 0.1);
  CHECK(solid.stiffness.interface.weight == 2.0);
  CHECK(solid.stiffness.interface.exponent == 1.0);
  CHECK(solid.stiffness.points.weight == 1.0);
  CHECK(solid.stiffness.points.length == 0.2);
  REQUIRE(solid.stiffness.at.size() == 2);
  CHECK(solid.stiffness.at[1] == std::array{3.0, 1.0, 0.0});
  CHECK(solid.stiffness.jacobian == 1.5);
  CHECK(solid.from == motion::From::last);
  CHECK(solid.poisson == -0.2);
  CHECK(solid.slide == std::vector<std::string>{"floor"});
  const auto& heat = std::get<motion::Harmonic>(read.variants[1].second.update);
  CHECK(heat.stiffness.base == 0.0);
  CHECK(heat.stiffness.jacobian == 1.0);
  CHECK(heat.from == motion::From::first);
  CHECK(std::get<motion::Biharmonic>(read.variants[2].second.update).slope == motion::Slope::zero);
}

TEST_CASE("mistakes in ways of moving the mesh are explained")
{
  CHECK(complaint(everything, {"motion.harmonic={}"}).find("[motion]: found 2 keys, allowed is one of") !=
        std::string::npos);
  CHECK(complaint(everything, {"compare.heat={ harmonic = { base = 0 } }"})
            .find("nothing makes the mesh stiff") != std::string::npos);
  CHECK(complaint(everything, {R"(compare.heat={ harmonic = { points = ["q"] } })"})
            .find("[compare.heat] harmonic: near_points and points belong together") != std::string::npos);
  CHECK(complaint(everything, {R"(compare.plate={ biharmonic = { slide = ["flour"] } })"})
            .find("[compare.plate] slide: 'flour' is no boundary that the fluid touches; did you mean "
                  "'floor'?") != std::string::npos);
  CHECK(complaint(everything, {R"(compare.plate={ biharmonic = { slide = ["outlet"] } })"})
            .find("nodes slide only along straight lines in x or y") != std::string::npos);
  CHECK(complaint(everything, {"compare.solid={ pseudo_solid = { poisson = 0.5 } }"})
            .find("[compare.solid] pseudo_solid.poisson: found 0.5") != std::string::npos);
  CHECK(complaint(everything, {"compare.solid={ pseudo_solid = { near_interface = { exponent = 2 } } }"})
            .find("the key 'length' is missing") != std::string::npos);
}

TEST_CASE("curves are read as they are written")
{
  const case_file::Case read = case_file::read(folder / "curves.toml");
  REQUIRE(read.layout.edges.size() == 9);
  const auto curve = [&](int i) -> const geometry::Curve& { return read.layout.edges[i].curve; };
  CHECK(std::get<geometry::Arc>(curve(0)).axis == geometry::Point{0, 0, 1});
  CHECK(std::get<geometry::Arc>(curve(1)).longer);
  CHECK(std::get<geometry::ArcThrough>(curve(2)).point == geometry::Point{2.4, -0.2, 0});
  CHECK(std::get<geometry::Ellipse>(curve(3)).second == geometry::Point{0, 0.5, 0});
  CHECK(std::get<geometry::Through>(curve(4)).parameters == std::vector<double>{0.4});
  CHECK(std::get<geometry::Through>(curve(4)).speed == geometry::Speed::own);
  CHECK(std::get<geometry::Spline>(curve(5)).curve.knots == std::vector<double>{0, 0, 0, 1, 1, 1});
  CHECK(std::get<geometry::Spline>(curve(6)).part);
  CHECK(std::get<geometry::Spline>(curve(7)).curve.weights == std::vector<double>{1, 2, 1});
  CHECK(std::get<geometry::Formula>(curve(8)).x[0](0.0, 0.0, 0.0, 0.25) == 8.75);
}

TEST_CASE("edges of STEP and IGES files are curves in metres")
{
  if (!geometry::reads_cad())
    return;
  const case_file::Case read = case_file::read(folder / "curves_cad.toml");
  REQUIRE(read.layout.edges.size() == 2);
  const auto ends = [&](int i)
  {
    const block::Edge& edge = read.layout.edges[i];
    return std::array{point(read, edge.a).x, point(read, edge.b).x};
  };
  const geometry::Curve& arc = read.layout.edges[0].curve;
  const geometry::Point middle = geometry::evaluate(arc, ends(0)[0], ends(0)[1], 0.5);
  CHECK(geometry::distance(middle, {0.5, 0.525, 0.0}) == doctest::Approx(0.725).epsilon(1e-12));
  CHECK(middle[0] < 0.4);
  // More than half of a circle of radius 0.5.
  const geometry::Curve& circle = read.layout.edges[1].curve;
  CHECK(geometry::length(circle, ends(1)[0], ends(1)[1]) ==
        doctest::Approx(0.5 * (3.14159265358979 + 2.0 * std::asin(0.28))).epsilon(1e-12));
  const std::string file = (folder / "part.step").string();
  CHECK(complaint(folder / "curves_cad.toml",
                  {"blocks.edges.'a - b'={ step = { file = '" + file + "', edge = 7 } }"})
            .find("has no edge 7; its edges have the numbers from 1 to 1") != std::string::npos);
}

TEST_CASE("a case brings the nodes on its edges and faces that checking it placed")
{
  const case_file::Case description = case_file::read(folder / "everything_3d.toml");
  const block::Skeleton skeleton = block::make_skeleton(description.layout);
  REQUIRE(description.skeleton != nullptr);
  CHECK((description.skeleton->x == skeleton.x));
  CHECK((description.skeleton->parameter == skeleton.parameter));
}
