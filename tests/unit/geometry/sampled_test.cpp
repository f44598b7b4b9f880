#include "geometry/sampled.hpp"

#include "core/error.hpp"
#include "differences.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

using namespace blockfsi;
using geometry::LevelSet;
using geometry::Point;
using geometry::Samples;

namespace
{

template <typename Function>
Samples sample(int n, int nz, Function f)
{
  Samples samples{
      {n, n + 1, nz}, {-1.0, -0.9, -0.5}, {2.0 / (n - 1), 2.0 / n, nz > 1 ? 1.0 / (nz - 1) : 0.0}, {}};
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < n + 1; ++j)
      for (int i = 0; i < n; ++i)
        samples.values.push_back(f(samples.origin[0] + i * samples.spacing[0],
                                   samples.origin[1] + j * samples.spacing[1],
                                   nz > 1 ? samples.origin[2] + k * samples.spacing[2] : 0.0));
  return samples;
}

double wave(double x, double y, double z)
{
  return std::sin(2.0 * x + 0.3) * std::cos(1.5 * y) + z * z * z * z;
}

double largest_error(int n, int nz)
{
  const LevelSet field = sampled(sample(n, nz, wave), "wave");
  double error = 0.0;
  for (double x = -0.99; x < 1.0; x += 0.173)
    for (double y = -0.89; y < 1.0; y += 0.191)
      for (double z = nz > 1 ? -0.49 : 0.0; z < (nz > 1 ? 0.5 : 0.1); z += 0.107)
        error = std::fmax(error, std::abs(field.value({x, y, z}) - wave(x, y, z)));
  return error;
}

struct TemporaryFile
{
  TemporaryFile(const std::string& name, const std::string& text)
      : path(std::filesystem::temp_directory_path() / ("blockfsi_sampled_" + name))
  {
    std::ofstream(path) << text;
  }
  ~TemporaryFile() { std::filesystem::remove(path); }
  std::filesystem::path path;
};

std::string complaint(const std::string& name, const std::string& text)
{
  const TemporaryFile file(name, text);
  try
  {
    sampled(geometry::read_samples(file.path), "");
  }
  catch (const Error& error)
  {
    const std::string start = "the file of samples '" + file.path.string() + "' ";
    return error.message().starts_with(start) ? error.message().substr(start.size()) : error.message();
  }
  return "accepted";
}

}  // namespace

TEST_CASE("samples of a cubic polynomial give it back up to the ends of the grid")
{
  const auto cubic = [](double x, double y, double z)
  { return 1.0 - x + x * x * y - 2.0 * y * y * y + x * y * z * z + z * z * z; };
  for (const int n : {4, 5, 6, 9})
  {
    const LevelSet field = sampled(sample(n, 4, cubic), "cubic");
    for (const Point& x : {Point{-1.0, -0.9, -0.5}, Point{0.99, 1.05, 0.49}, Point{0.1, 0.2, 0.3}})
    {
      CHECK(field.value(x) == doctest::Approx(cubic(x[0], x[1], x[2])).epsilon(1e-13));
      CHECK(field(x).gradient[0] ==
            doctest::Approx(-1.0 + 2.0 * x[0] * x[1] + x[1] * x[2] * x[2]).epsilon(1e-12));
    }
  }
}

TEST_CASE("the spline through samples is of order 4, with a gradient that is its own, in 2D and 3D")
{
  for (const int nz : {1, 0})
  {
    const double coarse = largest_error(11, nz == 1 ? 1 : 11);
    const double fine = largest_error(21, nz == 1 ? 1 : 21);
    CHECK(std::log2(coarse / fine) > 3.7);
  }
  const LevelSet field = sampled(sample(9, 7, wave), "wave");
  // The last points lie outside of the grid, across a side and across a corner.
  for (const Point& x :
       {Point{0.13, 0.27, 0.11}, Point{-0.77, 0.51, -0.4}, Point{1.3, 0.2, 0.1}, Point{1.3, -1.4, 0.9}})
    CHECK(gradient_error(field, x, 1e-4) < 1e-7);
  CHECK(field.value({1.3, 0.2, 0.1}) == doctest::Approx(field.value({1.0, 0.2, 0.1}) + 0.3).epsilon(1e-14));
}

TEST_CASE("the second derivative of the spline is continuous")
{
  const LevelSet field = sampled(sample(9, 1, wave), "wave");
  const auto curvature = [&](double x) {
    return (field({x + 1e-6, 0.3, 0.0}).gradient[0] - field({x, 0.3, 0.0}).gradient[0]) / 1e-6;
  };
  for (int i = 1; i < 8; ++i)
  {
    const double node = -1.0 + 0.25 * i;
    CHECK(curvature(node) == doctest::Approx(curvature(node - 1e-6)).epsilon(1e-4));
  }
}

TEST_CASE("samples are read from a text and from a VTK image")
{
  std::string values;
  for (int i = 0; i < 20; ++i)
    values += std::to_string(0.5 * i) + (i % 4 == 3 ? "\n" : " ");
  const TemporaryFile text("grid.txt", "4 5 1\n0 -1 0\n0.5 0.25 0\n" + values);
  const TemporaryFile image("grid.vti",
                            "<?xml version=\"1.0\"?>\n<VTKFile type=\"ImageData\">\n<ImageData "
                            "WholeExtent=\"0 3 4 8 0 0\" Origin=\"0 -2 0\" "
                            "Spacing=\"0.5 0.25 1\">\n<Piece Extent=\"0 3 4 8 0 0\">\n<PointData "
                            "Scalars=\"phi\">\n<DataArray type=\"Float64\" "
                            "Name=\"phi\" format=\"ascii\">\n" +
                                values + "</DataArray>\n</PointData>\n</Piece>\n</ImageData>\n</VTKFile>\n");
  for (const std::filesystem::path& path : {text.path, image.path})
  {
    const LevelSet field = sampled(geometry::read_samples(path), "grid");
    CHECK(field.value({0.5, -0.75, 9.0}) == doctest::Approx(2.5).epsilon(1e-14));
    CHECK(field.value({0.75, -0.5, 0.0}) == doctest::Approx(4.75).epsilon(1e-14));
  }
}

TEST_CASE("files of samples that cannot be used are refused with the reason")
{
  CHECK(complaint("a.txt", "") ==
        "cannot be read or is empty; give the path of a .vti file or of a text with samples");
  CHECK(complaint("b.txt", "4 4 1 0 0 0 1 1") == "ends where the spacing should stand");
  CHECK(complaint("c.txt", "4 four 1") == "found 'four' where a number of points should stand");
  CHECK(complaint("d.txt", "4 4 1 0 0 0 1 1 1 7") == "ends where a sample should stand");
  CHECK(complaint("e.txt", "1.5 4 1") ==
        "has 1.5 points in one direction; allowed are whole numbers from 1 to 1e+05");
  CHECK(complaint("f.txt", "99999 99999 99999 0 0 0 1 1 1") == "has 1e+15 points; allowed are 1e+09");
  CHECK(complaint("g.txt", "3 4 1 0 0 0 1 1 1 0 0 0 0 0 0 0 0 0 0 0 0") ==
        "the samples have 3 points in x; a cubic spline needs 4 or more");
  CHECK(complaint("h.vti", "<VTKFile>") == "has no <ImageData WholeExtent=\"...\">");
  CHECK(complaint("i.vti",
                  "<ImageData WholeExtent=\"0 3 0 3 0 0\" Origin=\"0 0 0\" Spacing=\"1 1 1\"><PointData>"
                  "<DataArray format=\"appended\">") ==
        "holds its samples as 'appended'; write it with format=\"ascii\"");
  CHECK(complaint("j.txt", "4 4 1 0 0 0 1 0 1 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0") ==
        "the spacing of the samples in y is 0 m; it must be positive");
}
