#include "MethodView.h"

#include "Comparison/vtkComparisonMapper.h"
#include "FrameCost.h"

#include <vtkVariationFieldVolumeMapper.h>

namespace varimarch
{

MethodView::MethodView(const BenchMethod& method, const Scene& scene, vtkImageData* image)
  : view(scene, image, method.kind)
{
  if (method.comparison)
  {
    this->comparison = vtkSmartPointer<vtkComparisonMapper>::New();
    this->comparison->SetMethod(*method.comparison);
    this->comparison->SetStorage(method.storage);
    this->comparison->SetCorrectedTable(method.correctedTable);
    this->comparison->SetInputDataObject(image);
    this->view.Pipeline().Volume()->SetMapper(this->comparison);
  }
}

MethodView::~MethodView() = default;

void MethodView::SetOptions(const RenderOptions& options)
{
  this->view.Pipeline().SetRenderOptions(options);
  if (this->comparison)
  {
    this->comparison->SetSampleDistance(options.sampleDistanceMm.value_or(1.0));
    this->comparison->SetEarlyTerminationTransmittance(options.earlyTerminationTransmittance);
  }
}

double MethodView::UsedSampleDistanceMm() const
{
  return this->comparison ? this->comparison->GetSampleDistance()
                          : this->view.Pipeline().UsedSampleDistanceMm();
}

double MethodView::EstimatedError()
{
  auto* const ours = vtkVariationFieldVolumeMapper::SafeDownCast(this->view.Pipeline().Mapper());
  return ours && !this->comparison ? ours->GetEstimatedError() : 0.0;
}

std::optional<double> MethodView::Fetches()
{
  return this->comparison ? std::nullopt : FetchesPerPixel(this->view);
}

std::optional<double> MethodView::Bytes()
{
  return this->comparison ? this->comparison->GetGraphicsMemoryBytes() : GraphicsBytes(this->view);
}

}
