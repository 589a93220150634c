#include "Scene/OrbitBenchmark.h"

#include "Core/Quality/ImageError.h"
#include "Scene/Median.h"

#include <vtkCamera.h>

#include <algorithm>
#include <cmath>
#include <locale>
#include <sstream>

namespace varimarch
{

namespace
{

ImageError DifferenceOf(vtkImageData* picture, vtkImageData* from)
{
  return CompareImages(static_cast<const float*>(picture->GetScalarPointer()),
    static_cast<const float*>(from->GetScalarPointer()), std::size_t(from->GetNumberOfPoints()));
}

void Turn(OffscreenView& view, double degrees)
{
  vtkRenderer* const renderer = view.Pipeline().Renderer();
  renderer->GetActiveCamera()->Azimuth(degrees);
  renderer->ResetCameraClippingRange();
}

}

OrbitBenchmark::OrbitBenchmark(
  const Scene& scene, vtkImageData* image, MapperKind theirs, int pictures)
  : ours(scene, image, MapperKind::Varimarch)
  , theirs(scene, image, theirs)
  , count(pictures)
{
  this->ours.Render();
  this->theirs.Render();
}

void OrbitBenchmark::ShowLabels(
  std::shared_ptr<const LabelMap> labels, const std::vector<Segment>& segments)
{
  for (OffscreenView* const view : { &this->ours, &this->theirs })
  {
    view->Pipeline().SetLabels(labels);
    view->Pipeline().SetSegments(segments);
    view->Render();
  }
}

void OrbitBenchmark::DrawNext()
{
  OrbitPicture picture;
  picture.degrees = 360.0 * double(this->drawn.size()) / this->count;
  picture.oursMs = 1000.0 * this->ours.Render();
  picture.theirsMs = 1000.0 * this->theirs.Render();
  const ImageError error = DifferenceOf(this->theirs.FloatImage(), this->ours.FloatImage());
  picture.rootMeanSquare = error.rootMeanSquare;
  picture.largest = error.largest;
  this->drawn.push_back(picture);
  for (OffscreenView* const view : { &this->ours, &this->theirs })
  {
    Turn(*view, 360.0 / this->count);
  }
}

OrbitSummary SummaryOf(const std::vector<OrbitPicture>& pictures)
{
  OrbitSummary summary = {};
  std::vector<double> ours;
  std::vector<double> theirs;
  for (const OrbitPicture& picture : pictures)
  {
    ours.push_back(picture.oursMs);
    theirs.push_back(picture.theirsMs);
    summary.rootMeanSquare += picture.rootMeanSquare * picture.rootMeanSquare / pictures.size();
    summary.largest = std::max(summary.largest, picture.largest);
  }
  summary.medianOursMs = Median(std::move(ours));
  summary.medianTheirsMs = Median(std::move(theirs));
  summary.rootMeanSquare = std::sqrt(summary.rootMeanSquare);
  return summary;
}

std::string CsvOf(const std::vector<OrbitPicture>& pictures)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << "degrees,ours_ms,vtk_ms,rmse_255,largest_255\n";
  for (const OrbitPicture& picture : pictures)
  {
    text << picture.degrees << ',' << picture.oursMs << ',' << picture.theirsMs << ','
         << picture.rootMeanSquare << ',' << picture.largest << '\n';
  }
  return text.str();
}

}
