#include "LogLogPlot.h"

#include "Scene/ImageFiles.h"
#include "Scene/OutputFile.h"

#include <vtkAxis.h>
#include <vtkChartLegend.h>
#include <vtkChartXY.h>
#include <vtkContextActor.h>
#include <vtkContextScene.h>
#include <vtkDoubleArray.h>
#include <vtkHeadlessRenderWindow.h>
#include <vtkNew.h>
#include <vtkOpenGLGL2PSExporter.h>
#include <vtkPen.h>
#include <vtkPlotLine.h>
#include <vtkRenderer.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkTextProperty.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace varimarch
{

namespace
{

constexpr int Width = 1400; // pixels
constexpr int Height = 900; // pixels
constexpr float LineWidth = 3.0f;
constexpr float MarkerSize = 15.0f;

struct Range
{
  double lowest;
  double highest;

  void Include(double value)
  {
    this->lowest = std::min(this->lowest, value);
    this->highest = std::max(this->highest, value);
  }
};

std::array<Range, 2> RangesOf(const LogLogPlot& plot)
{
  constexpr double Infinity = std::numeric_limits<double>::infinity();
  std::array<Range, 2> ranges = { Range{ Infinity, -Infinity }, Range{ Infinity, -Infinity } };
  for (const PlotCurve& curve : plot.curves)
  {
    for (const auto& point : curve.points)
    {
      ranges[0].Include(std::log10(point[0]));
      ranges[1].Include(std::log10(point[1]));
    }
  }
  for (const PlotLevel& level : plot.levels)
  {
    ranges[1].Include(std::log10(level.y));
  }
  return ranges;
}

int StrokeNumber(Stroke stroke)
{
  switch (stroke)
  {
    case Stroke::Dashed:
      return vtkPen::DASH_LINE;
    case Stroke::Dotted:
      return vtkPen::DOT_LINE;
    default:
      return vtkPen::SOLID_LINE;
  }
}

int MarkerNumber(Marker marker)
{
  switch (marker)
  {
    case Marker::Square:
      return vtkPlotPoints::SQUARE;
    case Marker::Diamond:
      return vtkPlotPoints::DIAMOND;
    case Marker::Plus:
      return vtkPlotPoints::PLUS;
    case Marker::Cross:
      return vtkPlotPoints::CROSS;
    default:
      return vtkPlotPoints::CIRCLE;
  }
}

std::string Short(double number)
{
  std::ostringstream stream;
  stream << number;
  return stream.str();
}

/// A plot as VTK's chart in a window of its own.
class ChartWindow
{
public:
  explicit ChartWindow(const LogLogPlot& plot)
    : ranges(RangesOf(plot))
  {
    this->window->SetSize(Width, Height);
    this->window->SetMultiSamples(8);
    if (!this->window->InitializeContext())
    {
      throw std::runtime_error(this->window->GetFailureReason());
    }
    vtkNew<vtkContextActor> actor;
    actor->GetScene()->AddItem(this->chart);
    actor->GetScene()->SetRenderer(this->renderer);
    this->renderer->AddActor(actor);
    this->renderer->SetBackground(1.0, 1.0, 1.0);
    this->window->AddRenderer(this->renderer);

    this->chart->SetTitle(plot.title);
    this->chart->GetTitleProperties()->SetFontSize(26);
    this->AddAxis(vtkAxis::BOTTOM, plot.xTitle, this->ranges[0]);
    this->AddAxis(vtkAxis::LEFT, plot.yTitle, this->ranges[1]);
    for (const PlotLevel& level : plot.levels)
    {
      this->AddLevel(level);
    }
    for (const PlotCurve& curve : plot.curves)
    {
      this->AddCurve(curve);
    }
    this->ShowLegend();
    this->window->Render();
  }

  vtkHeadlessRenderWindow* Window() { return this->window; }

private:
  // The chart's own logarithmic axes label only decades, so we plot logarithms on linear axes and
  // label the original values.
  void AddAxis(int side, const std::string& title, const Range& range)
  {
    constexpr double Margin = 0.08;
    vtkAxis* axis = this->chart->GetAxis(side);
    axis->SetTitle(title);
    axis->GetTitleProperties()->SetFontSize(22);
    axis->GetTitleProperties()->SetBold(false);
    axis->GetLabelProperties()->SetFontSize(20);
    axis->GetGridPen()->SetColor(225, 225, 225);
    axis->GetPen()->SetColor(60, 60, 60);
    axis->SetBehavior(vtkAxis::FIXED);
    axis->SetRange(range.lowest - Margin, range.highest + Margin);

    const bool crowded = range.highest - range.lowest > 2.5;
    vtkNew<vtkDoubleArray> positions;
    vtkNew<vtkStringArray> labels;
    for (int decade = int(std::floor(range.lowest)) - 1; decade <= range.highest + 1; ++decade)
    {
      for (const double digit : { 1.0, 2.0, 5.0 })
      {
        const double position = decade + std::log10(digit);
        const bool inside = position >= range.lowest - Margin && position <= range.highest + Margin;
        if (inside && (digit == 1.0 || !crowded))
        {
          positions->InsertNextValue(position);
          labels->InsertNextValue(Short(std::pow(10.0, decade) * digit));
        }
      }
    }
    axis->SetCustomTickPositions(positions, labels);
  }

  vtkPlotLine* AddLine(const std::string& title, const std::vector<std::array<double, 2>>& logs)
  {
    vtkNew<vtkTable> table;
    for (const int column : { 0, 1 })
    {
      vtkNew<vtkDoubleArray> values;
      values->SetName(column == 0 ? "x" : title.c_str());
      for (const auto& point : logs)
      {
        values->InsertNextValue(point[column]);
      }
      table->AddColumn(values);
    }
    auto* line = vtkPlotLine::SafeDownCast(this->chart->AddPlot(vtkChart::LINE));
    line->SetInputData(table, 0, 1);
    return line;
  }

  void AddCurve(const PlotCurve& curve)
  {
    std::vector<std::array<double, 2>> logs;
    for (const auto& point : curve.points)
    {
      logs.push_back({ std::log10(point[0]), std::log10(point[1]) });
    }
    if (logs.empty())
    {
      return;
    }
    // VTK refuses to paint a line of one point.
    logs.push_back(logs.back());
    vtkPlotLine* line = this->AddLine(curve.title, logs);
    const auto& [red, green, blue] = curve.style.color;
    line->SetColor(red, green, blue, 255);
    line->SetWidth(LineWidth);
    line->GetPen()->SetLineType(StrokeNumber(curve.style.stroke));
    line->SetMarkerStyle(MarkerNumber(curve.style.marker));
    line->SetMarkerSize(MarkerSize);
  }

  void AddLevel(const PlotLevel& level)
  {
    const double height = std::log10(level.y);
    vtkPlotLine* line = this->AddLine(
      level.title, { { this->ranges[0].lowest, height }, { this->ranges[0].highest, height } });
    line->SetColor(120, 120, 120, 255);
    line->SetWidth(LineWidth);
    line->GetPen()->SetLineType(vtkPen::DASH_DOT_LINE);
    line->SetMarkerStyle(vtkPlotPoints::NONE);
  }

  // The legend is beside the plot, where it hides no curve.
  void ShowLegend()
  {
    this->chart->SetShowLegend(true);
    vtkChartLegend* legend = this->chart->GetLegend();
    legend->SetInline(false);
    legend->SetHorizontalAlignment(vtkChartLegend::RIGHT);
    legend->SetVerticalAlignment(vtkChartLegend::TOP);
    legend->SetLabelSize(20);
    legend->SetSymbolWidth(70);
  }

  std::array<Range, 2> ranges;
  vtkNew<vtkHeadlessRenderWindow> window;
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkChartXY> chart;
};

}

vtkSmartPointer<vtkImageData> DrawPlot(const LogLogPlot& plot)
{
  ChartWindow chart(plot);
  vtkNew<vtkWindowToImageFilter> reader;
  reader->SetInput(chart.Window());
  reader->ReadFrontBufferOff();
  reader->Update();
  return reader->GetOutput();
}

void WritePlotSvg(const LogLogPlot& plot, const std::string& path)
{
  ChartWindow chart(plot);
  // vtkSVGExporter clips the curves away. This exporter adds the file's extension itself.
  vtkNew<vtkOpenGLGL2PSExporter> exporter;
  exporter->SetRenderWindow(chart.Window());
  exporter->SetFileFormatToSVG();
  exporter->CompressOff();
  exporter->SilentOn(); // it warns that it cannot embed the empty background
  exporter->SetTitle(plot.title.c_str());
  WriteFileWhole(path,
    [&](const std::string& part)
    {
      exporter->SetFilePrefix(std::filesystem::path(part).replace_extension().c_str());
      exporter->Write();
      return std::filesystem::exists(part);
    });
}

bool WritePlot(const LogLogPlot& plot, const std::filesystem::path& stem)
{
  if (plot.curves.empty())
  {
    return false;
  }
  WritePng(DrawPlot(plot), stem.string() + ".png");
  WritePlotSvg(plot, stem.string() + ".svg");
  return true;
}

}
