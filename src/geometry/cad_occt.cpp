// The CAD reader on Open CASCADE, whose headers are seen nowhere else.
#ifdef BLOCKFSI_CAD

#include "core/error.hpp"
#include "geometry/cad.hpp"
#include "geometry/refit.hpp"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepBndLib.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <GeomAdaptor_Curve.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_OffsetCurve.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <IGESControl_Reader.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>
#include <Precision.hxx>
#include <STEPControl_Reader.hxx>
#include <Standard_Failure.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace blockfsi::geometry
{

struct CadFile::Shapes
{
  std::string name;
  TopTools_IndexedMapOfShape edge_map;
  TopTools_IndexedMapOfShape face_map;
  std::vector<CadItem> edges;
  std::vector<CadItem> faces;
};

namespace
{

/// Open CASCADE's unit is the millimetre, to which it converts files of other units.
constexpr double millimetre = 1e-3;
/// How far refitted curves and surfaces may be off, relative to their size.
constexpr double refit_tolerance = 1e-10;

template <typename Vector>
Point metres(const Vector& p)
{
  return {millimetre * p.X(), millimetre * p.Y(), millimetre * p.Z()};
}

template <typename Vector>
Point plain(const Vector& p)
{
  return {p.X(), p.Y(), p.Z()};
}

/// Failures of Open CASCADE as errors of ours, after `what`.
template <typename Make>
auto guarded(const std::string& what, const Make& make)
{
  try
  {
    return make();
  }
  catch (const Standard_Failure& failure)
  {
    throw Error(fmt::format("{}: Open CASCADE fails with {}", what, failure.GetMessageString()));
  }
  catch (const Error& error)
  {
    throw error.within(what);
  }
}

/// Open CASCADE talks on standard output otherwise.
void silence()
{
  Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_Printer));
}

template <typename Reader>
TopoDS_Shape transfer(const std::string& name)
{
  Reader reader;
  if (reader.ReadFile(name.c_str()) != IFSelect_RetDone)
    throw Error("it is no file of the kind that its name ends in");
  reader.TransferRoots();
  return reader.OneShape();
}

TopoDS_Shape read_shape(const std::string& name, bool iges)
{
  return iges ? transfer<IGESControl_Reader>(name) : transfer<STEPControl_Reader>(name);
}

const char* type_name(GeomAbs_CurveType type)
{
  constexpr std::array<const char*, 9> names{"line",   "circle",   "ellipse", "hyperbola", "parabola",
                                             "Bezier", "B-spline", "offset",  "other"};
  return names[std::min<std::size_t>(type, names.size() - 1)];
}

const char* type_name(GeomAbs_SurfaceType type)
{
  constexpr std::array<const char*, 11> names{"plane",     "cylinder", "cone",     "sphere",
                                              "torus",     "Bezier",   "B-spline", "revolution",
                                              "extrusion", "offset",   "other"};
  return names[std::min<std::size_t>(type, names.size() - 1)];
}

CadItem with_box(int number, const TopoDS_Shape& shape)
{
  Bnd_Box box;
  BRepBndLib::AddOptimal(shape, box, false, false);
  CadItem item;
  item.number = number;
  if (!box.IsVoid())
  {
    item.low = metres(box.CornerMin());
    item.high = metres(box.CornerMax());
  }
  return item;
}

CadItem describe_edge(int number, const TopoDS_Edge& edge)
{
  CadItem item = with_box(number, edge);
  item.type = "point";
  if (BRep_Tool::Degenerated(edge))
    return item;
  const BRepAdaptor_Curve curve(edge);
  item.type = type_name(curve.GetType());
  item.start = metres(curve.Value(curve.FirstParameter()));
  item.end = metres(curve.Value(curve.LastParameter()));
  item.length = millimetre * GCPnts_AbscissaPoint::Length(curve);
  return item;
}

CadItem describe_face(int number, const TopoDS_Face& face)
{
  CadItem item = with_box(number, face);
  item.type = type_name(BRepAdaptor_Surface(face).GetType());
  return item;
}

template <typename Knots, typename Multiplicities>
std::vector<double> repeated(const Knots& knots, const Multiplicities& multiplicities)
{
  std::vector<double> result;
  for (int i = knots.Lower(); i <= knots.Upper(); ++i)
    result.insert(result.end(), multiplicities(i), knots(i));
  return result;
}

NurbsCurve to_own(const Handle(Geom_BSplineCurve) & spline)
{
  if (spline->IsPeriodic())
    spline->SetNotPeriodic();
  const int last = spline->NbKnots();
  if (spline->Multiplicity(1) <= spline->Degree() || spline->Multiplicity(last) <= spline->Degree())
    spline->Segment(spline->FirstParameter(), spline->LastParameter());
  NurbsCurve result;
  result.degree = spline->Degree();
  result.knots = repeated(spline->Knots(), spline->Multiplicities());
  for (int i = 1; i <= spline->NbPoles(); ++i)
  {
    result.points.push_back(metres(spline->Pole(i)));
    if (spline->IsRational())
      result.weights.push_back(spline->Weight(i));
  }
  return result;
}

NurbsSurface to_own(const Handle(Geom_BSplineSurface) & spline)
{
  if (spline->IsUPeriodic())
    spline->SetUNotPeriodic();
  if (spline->IsVPeriodic())
    spline->SetVNotPeriodic();
  const bool clamped = spline->UMultiplicity(1) > spline->UDegree() &&
                       spline->VMultiplicity(1) > spline->VDegree() &&
                       spline->UMultiplicity(spline->NbUKnots()) > spline->UDegree() &&
                       spline->VMultiplicity(spline->NbVKnots()) > spline->VDegree();
  if (!clamped)
  {
    double u0, u1, v0, v1;
    spline->Bounds(u0, u1, v0, v1);
    spline->Segment(u0, u1, v0, v1);
  }
  NurbsSurface result;
  result.degrees = {spline->UDegree(), spline->VDegree()};
  result.knots = {repeated(spline->UKnots(), spline->UMultiplicities()),
                  repeated(spline->VKnots(), spline->VMultiplicities())};
  for (int i = 1; i <= spline->NbUPoles(); ++i)
    for (int j = 1; j <= spline->NbVPoles(); ++j)
    {
      result.points.push_back(metres(spline->Pole(i, j)));
      if (spline->IsURational() || spline->IsVRational())
        result.weights.push_back(spline->Weight(i, j));
    }
  return result;
}

/// Where a curve or a surface may be less smooth, from 0 to 1; `intervals` are Open CASCADE's.
std::vector<double> breaks_of(const TColStd_Array1OfReal& intervals)
{
  std::vector<double> result;
  for (int i = intervals.Lower(); i <= intervals.Upper(); ++i)
    result.push_back((intervals(i) - intervals.First()) / (intervals.Last() - intervals.First()));
  return result;
}

CadCurve refitted(const Handle(Geom_Curve) & curve, double size)
{
  const GeomAdaptor_Curve adaptor(curve);
  TColStd_Array1OfReal intervals(1, adaptor.NbIntervals(GeomAbs_CN) + 1);
  adaptor.Intervals(intervals, GeomAbs_CN);
  const double first = curve->FirstParameter();
  const double last = curve->LastParameter();
  const auto result = refit([&](double t) { return metres(curve->Value((1.0 - t) * first + t * last)); },
                            breaks_of(intervals), refit_tolerance * size);
  return {result.spline, result.error};
}

CadSurface refitted(const Handle(Geom_Surface) & surface, double size)
{
  const GeomAdaptor_Surface adaptor(surface);
  TColStd_Array1OfReal u(1, adaptor.NbUIntervals(GeomAbs_CN) + 1);
  TColStd_Array1OfReal v(1, adaptor.NbVIntervals(GeomAbs_CN) + 1);
  adaptor.UIntervals(u, GeomAbs_CN);
  adaptor.VIntervals(v, GeomAbs_CN);
  const auto value = [&](double s, double t)
  {
    return metres(surface->Value((1.0 - s) * u.First() + s * u.Last(), (1.0 - t) * v.First() + t * v.Last()));
  };
  const auto result = refit(value, breaks_of(u), breaks_of(v), refit_tolerance * size);
  return {result.spline, {}, result.error};
}

/// The plane, sphere, cylinder or torus that a surface is part of.
Surface whole_surface(const Handle(Geom_Surface) & surface, const NurbsSurface& patch)
{
  if (const auto plane = Handle(Geom_Plane)::DownCast(surface))
  {
    const gp_Ax3 at = plane->Position();
    return Plane{metres(at.Location()), plain(at.XDirection()), plain(at.YDirection())};
  }
  if (const auto sphere = Handle(Geom_SphericalSurface)::DownCast(surface))
  {
    const gp_Ax3 at = sphere->Position();
    return Sphere{metres(at.Location()), millimetre * sphere->Radius(), plain(at.Direction()),
                  plain(at.XDirection())};
  }
  if (const auto cylinder = Handle(Geom_CylindricalSurface)::DownCast(surface))
  {
    const gp_Ax3 at = cylinder->Position();
    return Cylinder{metres(at.Location()), millimetre * cylinder->Radius(), plain(at.Direction()),
                    plain(at.XDirection())};
  }
  if (const auto torus = Handle(Geom_ToroidalSurface)::DownCast(surface);
      !torus.IsNull() && torus->MinorRadius() < torus->MajorRadius())
  {
    const gp_Ax3 at = torus->Position();
    return Torus{metres(at.Location()), millimetre * torus->MajorRadius(), millimetre * torus->MinorRadius(),
                 plain(at.Direction()), plain(at.XDirection())};
  }
  return patch;
}

/// Whether a curve or surface, or the one that it trims, is an offset, which no B-spline is exactly.
bool is_offset(Handle(Geom_Curve) curve)
{
  while (const auto trimmed = Handle(Geom_TrimmedCurve)::DownCast(curve))
    curve = trimmed->BasisCurve();
  return !Handle(Geom_OffsetCurve)::DownCast(curve).IsNull();
}

bool is_offset(Handle(Geom_Surface) surface)
{
  while (const auto trimmed = Handle(Geom_RectangularTrimmedSurface)::DownCast(surface))
    surface = trimmed->BasisSurface();
  return !Handle(Geom_OffsetSurface)::DownCast(surface).IsNull();
}

void snap(double& value, double end, double tolerance)
{
  if (std::abs(value - end) <= tolerance)
    value = end;
}

/// Bounds from vertices and edges are only as exact as Open CASCADE's tolerance; those that mean the ends of
/// the curve or the surface become these.
void snap_to_ends(const Handle(Geom_Curve) & curve, double& first, double& last)
{
  const double tolerance = 10.0 * GeomAdaptor_Curve(curve).Resolution(Precision::Confusion());
  snap(first, curve->FirstParameter(), tolerance);
  snap(last, curve->LastParameter(), tolerance);
}

void snap_to_ends(const Handle(Geom_Surface) & surface, double& u0, double& u1, double& v0, double& v1)
{
  const GeomAdaptor_Surface adaptor(surface);
  const double u_tolerance = 10.0 * adaptor.UResolution(Precision::Confusion());
  const double v_tolerance = 10.0 * adaptor.VResolution(Precision::Confusion());
  double s0, s1, t0, t1;
  surface->Bounds(s0, s1, t0, t1);
  snap(u0, s0, u_tolerance);
  snap(u1, s1, u_tolerance);
  snap(v0, t0, v_tolerance);
  snap(v1, t1, v_tolerance);
  if (!surface->IsUPeriodic())
  {
    u0 = std::max(u0, s0);
    u1 = std::min(u1, s1);
  }
  if (!surface->IsVPeriodic())
  {
    v0 = std::max(v0, t0);
    v1 = std::min(v1, t1);
  }
}

CadCurve convert(const TopoDS_Edge& edge, double size)
{
  double first = 0.0;
  double last = 0.0;
  const Handle(Geom_Curve) whole = BRep_Tool::Curve(edge, first, last);
  if (BRep_Tool::Degenerated(edge) || whole.IsNull())
    throw Error("it is a single point or has no curve in space; choose another one");
  snap_to_ends(whole, first, last);
  const Handle(Geom_Curve) curve = new Geom_TrimmedCurve(whole, first, last);
  if (is_offset(whole))
    return refitted(curve, size);
  return {to_own(GeomConvert::CurveToBSplineCurve(curve)), 0.0};
}

CadSurface convert(const TopoDS_Face& face, double size)
{
  Handle(Geom_Surface) whole = BRep_Tool::Surface(face);
  if (whole.IsNull())
    throw Error("it has no surface; choose another one");
  while (const auto trimmed = Handle(Geom_RectangularTrimmedSurface)::DownCast(whole))
    whole = trimmed->BasisSurface();
  double u0, u1, v0, v1;
  BRepTools::UVBounds(face, u0, u1, v0, v1);
  snap_to_ends(whole, u0, u1, v0, v1);
  const Handle(Geom_Surface) surface = new Geom_RectangularTrimmedSurface(whole, u0, u1, v0, v1);
  CadSurface result;
  if (is_offset(whole))
    result = refitted(surface, size);
  else
    result.patch = to_own(GeomConvert::SurfaceToBSplineSurface(surface));
  result.surface = whole_surface(whole, result.patch);
  return result;
}

double size_of(const CadItem& item)
{
  return distance(item.low, item.high);
}

void check_number(const std::string& name, const char* what, int number, std::size_t count)
{
  if (number < 1 || static_cast<std::size_t>(number) > count)
    throw Error(fmt::format("{} has no {} {}; its {}s have the numbers from 1 to {}", name, what, number,
                            what, count));
}

}  // namespace

bool reads_cad()
{
  return true;
}

CadFile::CadFile(const std::filesystem::path& path)
{
  const bool iges = is_iges(path);
  silence();
  const auto shapes = std::make_shared<Shapes>();
  shapes->name = path.string();
  guarded("the CAD file " + shapes->name,
          [&]
          {
            const TopoDS_Shape shape = read_shape(shapes->name, iges);
            if (!shape.IsNull())
            {
              TopExp::MapShapes(shape, TopAbs_EDGE, shapes->edge_map);
              TopExp::MapShapes(shape, TopAbs_FACE, shapes->face_map);
            }
            for (int i = 1; i <= shapes->edge_map.Extent(); ++i)
              shapes->edges.push_back(describe_edge(i, TopoDS::Edge(shapes->edge_map(i))));
            for (int i = 1; i <= shapes->face_map.Extent(); ++i)
              shapes->faces.push_back(describe_face(i, TopoDS::Face(shapes->face_map(i))));
          });
  if (shapes->edges.empty())
    throw Error(fmt::format("{} holds no edge of a shape", shapes->name));
  shapes_ = shapes;
}

const std::vector<CadItem>& CadFile::edges() const
{
  return shapes_->edges;
}

const std::vector<CadItem>& CadFile::faces() const
{
  return shapes_->faces;
}

CadCurve CadFile::edge(int number) const
{
  check_number(shapes_->name, "edge", number, shapes_->edges.size());
  return guarded(
      fmt::format("edge {} of {}", number, shapes_->name),
      [&] { return convert(TopoDS::Edge(shapes_->edge_map(number)), size_of(shapes_->edges[number - 1])); });
}

CadSurface CadFile::face(int number) const
{
  check_number(shapes_->name, "face", number, shapes_->faces.size());
  return guarded(
      fmt::format("face {} of {}", number, shapes_->name),
      [&] { return convert(TopoDS::Face(shapes_->face_map(number)), size_of(shapes_->faces[number - 1])); });
}

}  // namespace blockfsi::geometry

#endif
