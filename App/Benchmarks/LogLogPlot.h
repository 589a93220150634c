#ifndef Varimarch_Benchmarks_LogLogPlot_h
#define Varimarch_Benchmarks_LogLogPlot_h

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace varimarch
{

enum class Marker
{
  Circle,
  Square,
  Diamond,
  Plus,
  Cross,
};

enum class Stroke
{
  Solid,
  Dashed,
  Dotted,
};

/// The style of a curve. Curves should differ in more than colour, for colour-blind readers and for
/// print in black and white.
struct CurveStyle
{
  std::array<unsigned char, 3> color;
  Marker marker;
  Stroke stroke;
};

struct PlotCurve
{
  std::string title;
  CurveStyle style;
  std::vector<std::array<double, 2>> points; ///< distinct points x, y, each > 0
};

/// A labelled value of y, drawn as a grey line across the plot.
struct PlotLevel
{
  std::string title;
  double y; ///< value, > 0
};

/// Curves over two logarithmic axes, as for work-precision diagrams: E. Hairer, G. Wanner, "Solving
/// ordinary differential equations II", 1996.
struct LogLogPlot
{
  std::string title;
  std::string xTitle;
  std::string yTitle;
  std::vector<PlotCurve> curves; ///< curves, with at least one point in total
  std::vector<PlotLevel> levels;
};

/// Draws the plot as a byte image.
vtkSmartPointer<vtkImageData> DrawPlot(const LogLogPlot& plot);

/// Writes the plot as SVG.
/// @throws std::runtime_error when there is no OpenGL, or the file cannot be written
void WritePlotSvg(const LogLogPlot& plot, const std::string& path);

/// Writes the plot as `stem`.png and `stem`.svg.
/// @return false, with nothing written, for a plot without curves
bool WritePlot(const LogLogPlot& plot, const std::filesystem::path& stem);

}

#endif
