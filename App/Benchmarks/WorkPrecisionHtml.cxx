#include "WorkPrecisionHtml.h"

#include "CommandLine/Results.h"
#include "Scene/Canvas.h"
#include "Scene/DifferencePicture.h"
#include "Scene/ImageFiles.h"
#include "ToleranceReport.h"
#include "WorkPrecisionReport.h"

#include <vtkBase64Utilities.h>

#include <sstream>

namespace varimarch
{

namespace
{

const char* const Style = R"(
body { font: 16px/1.5 sans-serif; color: #222; max-width: 1100px; margin: 2em auto; padding: 0 1em; }
table { border-collapse: collapse; margin: 1em 0; font-size: 14px; }
th, td { padding: 2px 10px; text-align: right; border-bottom: 1px solid #ddd; }
th:first-child, td:first-child { text-align: left; }
.pictures { display: flex; flex-wrap: wrap; gap: 12px; }
figure { margin: 0; width: 256px; }
figcaption { font-size: 13px; }
img { max-width: 100%; }
code { background: #f2f2f2; padding: 1px 4px; overflow-wrap: anywhere; }
)";

std::string Escaped(const std::string& text)
{
  std::string escaped;
  for (const char letter : text)
  {
    escaped += letter == '&' ? "&amp;"
      : letter == '<'        ? "&lt;"
      : letter == '>'        ? "&gt;"
      : letter == '"'        ? "&quot;"
                             : std::string(1, letter);
  }
  return escaped;
}

// A data URL with the bytes in base64.
std::string DataUri(const std::string& type, const std::string& bytes)
{
  // Four letters for every three bytes, rounded up.
  std::string encoded(4 * ((bytes.size() + 2) / 3), '\0');
  const auto length =
    vtkBase64Utilities::Encode(reinterpret_cast<const unsigned char*>(bytes.data()),
      static_cast<unsigned long>(bytes.size()), reinterpret_cast<unsigned char*>(encoded.data()));
  encoded.resize(length);
  return "data:" + type + ";base64," + encoded;
}

std::string Image(const std::string& type, const std::string& bytes, const std::string& words)
{
  return "<img src=\"" + DataUri(type, bytes) + "\" alt=\"" + Escaped(words) + "\">";
}

std::string Figure(vtkImageData* bytePicture, const std::string& words)
{
  return "<figure>" + Image("image/png", PngBytes(bytePicture), words) + "<figcaption>" +
    Escaped(words) + "</figcaption></figure>\n";
}

std::string Row(const char* cell, const std::vector<std::string>& texts)
{
  std::string row = "<tr>";
  for (const std::string& text : texts)
  {
    row += std::string("<") + cell + ">" + Escaped(text) + "</" + cell + ">";
  }
  return row + "</tr>\n";
}

std::string PicturesOf(const WorkPrecision& scene)
{
  const auto& background = scene.scene.background;
  Canvas scale(512, DifferenceScaleHeight, { 255, 255, 255 });
  DrawDifferenceScale(scale, 0, 0, 512);
  std::string html =
    "<h3>Images, with about one sample per voxel if possible</h3>\n<div class=\"pictures\">\n" +
    Figure(BytesOver(scene.truth.picture, background), "the truth");
  for (const WorkCurve& curve : scene.curves)
  {
    const WorkPoint& point = curve.points[curve.shown];
    html += Figure(BytesOver(curve.picture, background),
      curve.method.title + ", " + point.setting.label + ", every " +
        Fixed(point.sampleDistanceMm, 3) + " mm: " + Fixed(point.medianMs, 1) + " ms");
    html += Figure(DifferencePicture(curve.picture, scene.truth.picture),
      "its difference from the truth: RMSE " + Fixed(point.error.light.rootMeanSquare, 2) +
        ", largest " + Fixed(point.error.light.largest, 1) + " of 255");
  }
  return html + "</div>\n<p>" +
    Image("image/png", PngBytes(scale.Picture()), "scale of the differences") + "</p>\n";
}

std::string EqualErrorTable(const WorkPrecision& scene)
{
  const std::vector<EqualErrorRow> rows = EqualErrorRows(scene);
  if (rows.empty())
  {
    return "";
  }
  std::string html = "<h3>Our optical field at the error of VTK's GPU mapper</h3>\n<table>" +
    Row("th",
      { "VTK's sample distance [voxels]", "RMSE [1/255]", "VTK [ms]", "ours [ms]",
        "times as fast" });
  for (const EqualErrorRow& row : rows)
  {
    html += Row("td",
      { Fixed(row.voxels, 3), Fixed(row.rmse, 3), Fixed(row.vtkMs, 1),
        row.oursMs ? Fixed(*row.oursMs, 1) : "never as precise",
        row.oursMs ? Fixed(row.vtkMs / *row.oursMs, 2) : "" });
  }
  return html + "</table>\n";
}

std::string ToleranceTable(const WorkPrecision& scene)
{
  const std::vector<ToleranceRow> rows = ToleranceRows(scene);
  if (rows.empty())
  {
    return "";
  }
  std::string html =
    "<h3>How our defaults keep an error tolerance</h3>\n<table>" + Row("th", ToleranceHeadings());
  for (const ToleranceRow& row : rows)
  {
    html += Row("td", ToleranceCells(row));
  }
  return html + "</table>\n<p>" + Escaped(ToleranceExplanation()) + "</p>\n";
}

std::string FullTable(const WorkPrecision& scene)
{
  std::string html = "<h3>All settings</h3>\n<table>" +
    Row("th",
      { "method", "setting", "sample distance [mm]", "RMSE [1/255]", "99.9 %", "largest", "SSIM",
        "CIEDE2000 mean", "99 %", "fetches per pixel", "median [ms]" });
  std::string notes;
  for (const WorkCurve& curve : scene.curves)
  {
    for (const WorkPoint& point : curve.points)
    {
      const ImageError& light = point.error.light;
      const PerceptualError& perceived = point.error.perceived;
      html += Row("td",
        { curve.method.title, point.setting.label, Fixed(point.sampleDistanceMm, 3),
          Fixed(light.rootMeanSquare, 3), Fixed(light.percentile999, 2), Fixed(light.largest, 2),
          Fixed(perceived.structuralSimilarity, 5), Fixed(perceived.meanColorDifference, 3),
          Fixed(perceived.colorDifference99, 2),
          point.fetchesPerPixel ? Fixed(*point.fetchesPerPixel, 1) : "",
          Fixed(point.medianMs, 1) });
    }
    notes += curve.skipped.empty()
      ? ""
      : "<p>" + Escaped(curve.method.title + " was not run at " + curve.skipped) + ".</p>\n";
  }
  return html + "</table>\n" + notes;
}

std::string Section(const WorkPrecision& scene, const std::vector<std::string>& plotSvgs)
{
  const int* dimensions = scene.volume.image->GetDimensions();
  std::ostringstream facts;
  facts << dimensions[0] << " x " << dimensions[1] << " x " << dimensions[2] << " voxels of type "
        << scene.volume.image->GetScalarTypeAsString() << "; image of " << scene.scene.size[0]
        << " x " << scene.scene.size[1] << " pixels; look \"" << scene.scene.look.name << "\", "
        << (scene.scene.look.shading.enabled ? "shaded" : "not shaded")
        << ". Truth: " << Described(scene.truth) << ".";
  std::string plots;
  for (const std::string& svg : plotSvgs)
  {
    plots += "<p>" + Image("image/svg+xml", svg, "error over work of all methods") + "</p>\n";
  }
  return "<h2>" + Escaped(scene.name) + "</h2>\n<p>" + Escaped(facts.str()) + "</p>\n" + plots +
    EqualErrorTable(scene) + ToleranceTable(scene) + PicturesOf(scene) + FullTable(scene);
}

}

std::string WorkPrecisionHtml(
  const std::vector<WorkPrecision>& scenes, const WorkPrecisionPage& page)
{
  std::ostringstream head;
  head << page.machine.date << "; " << page.machine.processor << ", " << page.machine.cores
       << " cores, load before the start " << Fixed(page.machine.load, 1) << "; OpenGL renderer \""
       << scenes.front().openglRenderer << "\"; VTK " << page.machine.vtkVersion << ".";
  std::string html = "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
                     "<title>Work and precision</title><style>" +
    std::string(Style) + "</style></head><body>\n<h1>Work and precision</h1>\n<p>" +
    Escaped(head.str()) + "</p>\n<p>Made by <code>" + Escaped(page.commandText) +
    "</code></p>\n<p>Errors are those of float images in premultiplied RGBA without background; "
    "SSIM and CIEDE2000 are those of the image on its background. A time is the median of rounds "
    "that go through all methods and settings in turn; compare ratios, not milliseconds. Lower and "
    "further left is better.</p>\n";
  for (std::size_t i = 0; i < scenes.size(); ++i)
  {
    html += Section(scenes[i], page.plotSvgs[i]);
  }
  return html + "</body></html>\n";
}

}
