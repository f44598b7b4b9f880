#include "geometry/cad.hpp"

#include "core/error.hpp"
#include "geometry/curve.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

using namespace blockfsi;
using namespace blockfsi::geometry;

namespace
{

std::string message_of(const std::filesystem::path& path)
{
  try
  {
    const CadFile file(path);
  }
  catch (const Error& error)
  {
    return error.message();
  }
  return "";
}

}  // namespace

#ifdef BLOCKFSI_CAD

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <GC_MakeArcOfEllipse.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_OffsetSurface.hxx>
#include <IGESControl_Controller.hxx>
#include <IGESControl_Writer.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>
#include <STEPControl_Writer.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <gp_Elips.hxx>

namespace
{

/// A folder that goes with the test.
struct Folder
{
  std::filesystem::path path;
  Folder()
  {
    std::string name = (std::filesystem::temp_directory_path() / "blockfsi-cad-XXXXXX").string();
    path = mkdtemp(name.data());
  }
  ~Folder() { std::filesystem::remove_all(path); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
};

/// The shape written as STEP or IGES by Open CASCADE and read by us.
CadFile through_file(const TopoDS_Shape& shape, const std::string& name)
{
  Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_Printer));
  const Folder folder;
  const std::filesystem::path path = folder.path / name;
  if (path.extension() == ".step")
  {
    STEPControl_Writer writer;
    REQUIRE(writer.Transfer(shape, STEPControl_AsIs) == IFSelect_RetDone);
    REQUIRE(writer.Write(path.c_str()) == IFSelect_RetDone);
  }
  else
  {
    IGESControl_Controller::Init();
    IGESControl_Writer writer("MM", 1);  // solids and their faces as such
    REQUIRE(writer.AddShape(shape));
    REQUIRE(writer.Write(path.c_str()));
  }
  return CadFile(path);
}

Point metres(const gp_Pnt& p)
{
  return {1e-3 * p.X(), 1e-3 * p.Y(), 1e-3 * p.Z()};
}

/// IGES files have 9 digits, so that test numbers with more would not come back.
double rounded(double x)
{
  return std::round(100.0 * x) / 100.0;
}

Handle(Geom_BSplineCurve) make_curve()
{
  TColgp_Array1OfPnt poles(1, 6);
  TColStd_Array1OfReal weights(1, 6);
  for (int i = 1; i <= 6; ++i)
  {
    poles(i) = gp_Pnt(10.0 * i, rounded(7.0 * std::sin(2.0 * i)), rounded(3.0 * std::cos(1.0 * i)));
    weights(i) = 1.0 + 0.1 * i;
  }
  TColStd_Array1OfReal knots(1, 4);
  TColStd_Array1OfInteger multiplicities(1, 4);
  knots(1) = 0.0, knots(2) = 0.5, knots(3) = 2.0, knots(4) = 3.0;
  multiplicities(1) = 4, multiplicities(2) = 1, multiplicities(3) = 1, multiplicities(4) = 4;
  return new Geom_BSplineCurve(poles, weights, knots, multiplicities, 3);
}

Handle(Geom_BSplineSurface) make_surface()
{
  TColgp_Array2OfPnt poles(1, 5, 1, 4);
  TColStd_Array2OfReal weights(1, 5, 1, 4);
  for (int i = 1; i <= 5; ++i)
    for (int j = 1; j <= 4; ++j)
    {
      poles(i, j) = gp_Pnt(10.0 * i + j, 12.0 * j, rounded(5.0 * std::sin(1.0 * i * j)));
      weights(i, j) = rounded(1.0 + 0.2 * std::cos(1.0 * i + j));
    }
  TColStd_Array1OfReal u(1, 3), v(1, 2);
  TColStd_Array1OfInteger mu(1, 3), mv(1, 2);
  u(1) = 0.0, u(2) = 1.0, u(3) = 3.0;
  mu(1) = 4, mu(2) = 1, mu(3) = 4;
  v(1) = -1.0, v(2) = 1.0;
  mv(1) = 4, mv(2) = 4;
  return new Geom_BSplineSurface(poles, weights, u, v, mu, mv, 3, 3);
}

NurbsSurface to_own(const Handle(Geom_BSplineSurface) & surface)
{
  NurbsSurface result;
  result.degrees = {3, 3};
  result.knots = {std::vector<double>{0, 0, 0, 0, 1, 3, 3, 3, 3},
                  std::vector<double>{-1, -1, -1, -1, 1, 1, 1, 1}};
  for (int i = 1; i <= 5; ++i)
    for (int j = 1; j <= 4; ++j)
    {
      result.points.push_back(metres(surface->Pole(i, j)));
      result.weights.push_back(surface->Weight(i, j));
    }
  return result;
}

/// How far points of the patch are off a surface [m].
double largest_distance(const NurbsSurface& patch, const Surface& exact)
{
  double result = 0.0;
  for (int i = 0; i <= 20; ++i)
    for (int j = 0; j <= 20; ++j)
      result = std::max(result, closest(exact, evaluate(patch, i / 20.0, j / 20.0)).distance);
  return result;
}

int face_of_type(const CadFile& file, const std::string& type)
{
  for (const CadItem& item : file.faces())
    if (item.type == type)
      return item.number;
  return 0;
}

}  // namespace

TEST_CASE("a box through STEP and IGES has its edges and faces in metres")
{
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(gp_Pnt(10, 20, 30), 100, 200, 300).Shape();
  for (const char* name : {"box.step", "box.iges"})
  {
    const CadFile file = through_file(box, name);
    CHECK(file.faces().size() == 6);
    CHECK(file.edges().size() == 12);
    double sum = 0.0;
    for (const CadItem& item : file.edges())
    {
      CHECK((item.type == "line" || item.type == "B-spline"));
      CHECK(distance(item.start, item.end) == doctest::Approx(item.length).epsilon(1e-13));
      const CadCurve edge = file.edge(item.number);
      CHECK(edge.error == 0.0);
      const Curve curve = Spline{edge.curve};
      CHECK_NOTHROW(check(curve, item.start, item.end));
      CHECK(length(curve, item.start, item.end) == doctest::Approx(item.length).epsilon(1e-13));
      sum += item.length;
    }
    CHECK(sum == doctest::Approx(4 * 0.6).epsilon(1e-13));
    for (const CadItem& item : file.faces())
    {
      const CadSurface face = file.face(item.number);
      CHECK_NOTHROW(check(face.surface));
      for (int c = 0; c < 4; ++c)
      {
        const Point x = corner(Surface(face.patch), c);
        for (int i = 0; i < 3; ++i)
        {
          CHECK(x[i] > item.low[i] - 1e-12);
          CHECK(x[i] < item.high[i] + 1e-12);
        }
      }
    }
  }
}

TEST_CASE("a cylinder, a sphere and a torus through STEP are those shapes to rounding")
{
  const CadFile cylinder = through_file(BRepPrimAPI_MakeCylinder(20, 70).Shape(), "cylinder.step");
  const CadSurface mantle = cylinder.face(face_of_type(cylinder, "cylinder"));
  CHECK(largest_distance(mantle.patch, Cylinder{.radius = 0.02}) < 1e-12 * 0.02);
  CHECK(std::holds_alternative<Cylinder>(mantle.surface));
  CHECK(largest_distance(mantle.patch, mantle.surface) < 1e-12 * 0.02);
  const auto circle = std::find_if(cylinder.edges().begin(), cylinder.edges().end(),
                                   [](const CadItem& item) { return item.type == "circle"; });
  REQUIRE(circle != cylinder.edges().end());
  CHECK(circle->length == doctest::Approx(0.04 * 3.14159265358979).epsilon(1e-12));
  const NurbsCurve round = cylinder.edge(circle->number).curve;
  for (int i = 0; i <= 50; ++i)
  {
    const Point x = evaluate(round, i / 50.0);
    CHECK(std::abs(std::hypot(x[0], x[1]) - 0.02) < 1e-12 * 0.02);
  }

  const CadFile sphere = through_file(BRepPrimAPI_MakeSphere(gp_Pnt(1, 2, 3), 15).Shape(), "sphere.step");
  const CadSurface ball = sphere.face(1);
  CHECK(largest_distance(ball.patch, Sphere{{1e-3, 2e-3, 3e-3}, 0.015}) < 1e-12 * 0.015);
  CHECK(std::holds_alternative<Sphere>(ball.surface));

  const CadFile ring = through_file(BRepPrimAPI_MakeTorus(50, 10).Shape(), "torus.step");
  const CadSurface torus = ring.face(1);
  CHECK(largest_distance(torus.patch, Torus{.major = 0.05, .minor = 0.01}) < 1e-12 * 0.05);
  CHECK(std::holds_alternative<Torus>(torus.surface));
}

TEST_CASE("a torus and a cylinder through IGES lie on their shapes")
{
  const CadFile ring = through_file(BRepPrimAPI_MakeTorus(50, 10).Shape(), "torus.iges");
  REQUIRE(!ring.faces().empty());
  for (const CadItem& item : ring.faces())
    CHECK(largest_distance(ring.face(item.number).patch, Torus{.major = 0.05, .minor = 0.01}) < 1e-12 * 0.05);
  const CadFile cylinder = through_file(BRepPrimAPI_MakeCylinder(20, 70).Shape(), "cylinder.iges");
  int round = 0;
  for (const CadItem& item : cylinder.faces())
    if (item.type != "plane" &&
        largest_distance(cylinder.face(item.number).patch, Cylinder{.radius = 0.02}) < 1e-12 * 0.02)
      ++round;
  CHECK(round == 1);
}

TEST_CASE("B-spline curves and surfaces through STEP and IGES are the same, point for point")
{
  const Handle(Geom_BSplineCurve) curve = make_curve();
  const Handle(Geom_BSplineSurface) surface = make_surface();
  for (const char* ending : {".step", ".iges"})
  {
    const CadFile edges = through_file(BRepBuilderAPI_MakeEdge(curve).Edge(), std::string("curve") + ending);
    REQUIRE(edges.edges().size() == 1);
    CHECK(edges.edges()[0].type == "B-spline");
    const CadCurve edge = edges.edge(1);
    CHECK(edge.error == 0.0);
    for (int i = 0; i <= 30; ++i)
      CHECK(distance(evaluate(edge.curve, i / 30.0), metres(curve->Value(3.0 * i / 30.0))) < 1e-12 * 0.06);

    const CadFile faces =
        through_file(BRepBuilderAPI_MakeFace(surface, 1e-6).Face(), std::string("surface") + ending);
    REQUIRE(faces.faces().size() == 1);
    const CadSurface face = faces.face(1);
    CHECK(face.error == 0.0);
    for (int i = 0; i <= 20; ++i)
      for (int j = 0; j <= 20; ++j)
        CHECK(distance(evaluate(face.patch, i / 20.0, j / 20.0),
                       metres(surface->Value(3.0 * i / 20.0, -1.0 + 2.0 * j / 20.0))) < 1e-12 * 0.06);
  }
}

TEST_CASE("edges and faces keep the ranges to which they are trimmed")
{
  const Handle(Geom_BSplineCurve) curve = make_curve();
  const CadFile edges = through_file(BRepBuilderAPI_MakeEdge(curve, 0.25, 2.5).Edge(), "part.step");
  const NurbsCurve part = edges.edge(1).curve;
  CHECK(distance(evaluate(part, 0.0), metres(curve->Value(0.25))) < 1e-12 * 0.06);
  CHECK(distance(evaluate(part, 1.0), metres(curve->Value(2.5))) < 1e-12 * 0.06);
  CHECK(distance(evaluate(part, 0.4), metres(curve->Value(0.25 + 0.4 * 2.25))) < 1e-12 * 0.06);

  const gp_Elips ellipse(gp::XOY(), 30, 10);
  const CadFile arc = through_file(
      BRepBuilderAPI_MakeEdge(GC_MakeArcOfEllipse(ellipse, 0.3, 2.0, true).Value()).Edge(), "ellipse.step");
  const NurbsCurve bow = arc.edge(1).curve;
  for (int i = 0; i <= 20; ++i)
  {
    const Point x = evaluate(bow, i / 20.0);
    CHECK(std::abs(std::hypot(x[0] / 0.03, x[1] / 0.01) - 1.0) < 1e-12);
  }
  CHECK(distance(evaluate(bow, 0.0), {0.03 * std::cos(0.3), 0.01 * std::sin(0.3), 0}) < 1e-12 * 0.03);

  const Handle(Geom_BSplineSurface) surface = make_surface();
  const CadFile faces =
      through_file(BRepBuilderAPI_MakeFace(surface, 0.5, 2.5, -0.5, 0.75, 1e-6).Face(), "patch.step");
  const NurbsSurface patch = faces.face(1).patch;
  // STEP trims faces by edges in space, which Open CASCADE projects to 1e-7 mm.
  CHECK(distance(evaluate(patch, 0.0, 1.0), metres(surface->Value(0.5, 0.75))) < 1e-10);
  CHECK(distance(evaluate(patch, 0.3, 0.6), metres(surface->Value(0.5 + 0.3 * 2.0, -0.5 + 0.6 * 1.25))) <
        1e-10);
  CHECK(largest_distance(patch, to_own(surface)) < 1e-12 * 0.06);
}

TEST_CASE("offset surfaces, which are no B-splines, are refitted and tell their error")
{
  const Handle(Geom_OffsetSurface) surface = new Geom_OffsetSurface(make_surface(), 1.0);
  const CadFile faces = through_file(BRepBuilderAPI_MakeFace(surface, 1e-6).Face(), "offset_surface.step");
  const CadSurface face = faces.face(1);
  CHECK(face.error > 0.0);
  CHECK(face.error < 1e-10 * 0.08);
  for (int i = 0; i <= 17; ++i)
    for (int j = 0; j <= 13; ++j)
      CHECK(distance(evaluate(face.patch, i / 17.0, j / 13.0),
                     metres(surface->Value(3.0 * i / 17.0, -1.0 + 2.0 * j / 13.0))) <= 2.0 * face.error);
}

TEST_CASE("CAD files that cannot be used are refused with the reason")
{
  const Folder folder;
  const auto written = [&](const char* name, const std::string& content)
  {
    const std::filesystem::path path = folder.path / name;
    std::ofstream(path) << content;
    return path;
  };
  const std::filesystem::path missing = folder.path / "missing.step";
  CHECK(message_of(missing) == "cannot read " + missing.string() + ": there is no such file");
  const std::filesystem::path other = written("part.dwg", "x");
  CHECK(message_of(other) ==
        "cannot read " + other.string() + ": its name must end in .step, .stp, .iges or .igs");
  for (const char* name : {"text.step", "text.iges"})
  {
    const std::filesystem::path text = written(name, "this is no CAD file\n\n1 2 3\n");
    CHECK(message_of(text) != "");
    CHECK(message_of(written(name, "")) != "");
  }
  const CadFile box = through_file(BRepPrimAPI_MakeBox(1, 1, 1).Shape(), "box.step");
  CHECK_THROWS_AS(static_cast<void>(box.edge(13)), Error);
  CHECK_THROWS_AS(static_cast<void>(box.face(0)), Error);
  CHECK_THROWS_AS(static_cast<void>(box.face(-3)), Error);
  const CadFile sphere = through_file(BRepPrimAPI_MakeSphere(1).Shape(), "sphere.step");
  for (const CadItem& item : sphere.edges())
    if (item.type == "point")
      CHECK_THROWS_AS(static_cast<void>(sphere.edge(item.number)), Error);
}

TEST_CASE("the list of a CAD file has a line for each edge and face")
{
  const std::string list = describe(through_file(BRepPrimAPI_MakeBox(100, 200, 300).Shape(), "box.step"));
  CHECK(std::count(list.begin(), list.end(), '\n') == 12 + 6 + 2);
  CHECK(list.find(
            "edge   type        start x [m]           y           z     end x [m]           y           z   "
            "length [m]\n") == 0);
  CHECK(
      list.find(
          "line                  0           0           0             0           0         0.3   0.3\n") !=
      std::string::npos);
  CHECK(list.find("\nface   type         from x [m]           y           z      to x [m]           y        "
                  "   z\n") != std::string::npos);
  CHECK(
      list.find("plane               0.1           0           0           0.1         0.2         0.3\n") !=
      std::string::npos);
}

#else

TEST_CASE("a build without CAD says so")
{
  const std::filesystem::path path = std::filesystem::temp_directory_path() / "blockfsi-without-cad.step";
  std::ofstream(path) << "x";
  CHECK(message_of(path).find("built without CAD") != std::string::npos);
  std::filesystem::remove(path);
}

#endif
