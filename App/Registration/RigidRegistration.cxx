#include "Registration/RigidRegistration.h"

#include "Scene/Model/SceneCuts.h"
#include "Scene/Model/WorldVector.h"
#include "Scene/Volumes/Placing.h"
#include "Scene/Volumes/VolumeLoading.h"

#include <itkCommand.h>
#include <itkEuler3DTransform.h>
#include <itkImage.h>
#include <itkImageRegistrationMethodv4.h>
#include <itkMattesMutualInformationImageToImageMetricv4.h>
#include <itkRegistrationParameterScalesFromPhysicalShift.h>
#include <itkRegularStepGradientDescentOptimizerv4.h>

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkPointData.h>

#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <stdexcept>

namespace varimarch
{

namespace
{

using Image = itk::Image<float, 3>;
using Transform = itk::Euler3DTransform<double>;
using Metric = itk::MattesMutualInformationImageToImageMetricv4<Image, Image>;
using Optimizer = itk::RegularStepGradientDescentOptimizerv4<double>;
using Method = itk::ImageRegistrationMethodv4<Image, Image, Transform>;

constexpr int VoxelsPerSide = 160; // The copies that are compared have at most as many.
constexpr int Levels = 3;
constexpr int StepsPerLevel = 120;
constexpr int Bins = 48;
constexpr double SampledPart = 0.1;
constexpr int Seed = 1;

Image::Pointer ItkImageOf(vtkImageData* whole)
{
  const vtkSmartPointer<vtkImageData> small = SmallCopy(whole, VoxelsPerSide);
  auto image = Image::New();
  Image::RegionType region;
  Image::SpacingType spacing;
  Image::DirectionType direction;
  for (int axis = 0; axis < 3; ++axis)
  {
    region.SetSize(axis, small->GetDimensions()[axis]);
    spacing[axis] = small->GetSpacing()[axis];
    for (int row = 0; row < 3; ++row)
    {
      direction[row][axis] = small->GetDirectionMatrix()->GetElement(row, axis);
    }
  }
  image->SetRegions(region);
  image->SetSpacing(spacing);
  image->SetOrigin(small->GetOrigin());
  image->SetDirection(direction);
  image->Allocate();
  vtkDataArray* const scalars = small->GetPointData()->GetScalars();
  for (vtkIdType voxel = 0; voxel < scalars->GetNumberOfTuples(); ++voxel)
  {
    image->GetBufferPointer()[voxel] = float(scalars->GetComponent(voxel, 0));
  }
  return image;
}

/// ITK's transforms take points of the fixed image to the moving one, and turn about a centre.
Transform::Pointer TransformOf(const glm::dmat4& patientFromWorld, const glm::dvec3& center)
{
  auto transform = Transform::New();
  Transform::MatrixType turn;
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      turn[row][column] = patientFromWorld[column][row];
    }
  }
  const glm::dvec3 move = glm::dvec3(patientFromWorld * glm::dvec4(center, 1.0)) - center;
  transform->SetCenter(Transform::InputPointType(glm::value_ptr(center)));
  transform->SetMatrix(turn, 1e-6);
  transform->SetTranslation(Transform::OutputVectorType(glm::value_ptr(move)));
  return transform;
}

glm::dmat4 MotionOf(const Transform& transform)
{
  glm::dmat4 motion(1.0);
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      motion[column][row] = transform.GetMatrix()[row][column];
    }
    motion[3][row] = transform.GetOffset()[row];
  }
  return motion;
}

struct Cancelled
{
};

/// Reports the steps of all levels, and ends the search by an exception.
class StepObserver : public itk::Command
{
public:
  using Self = StepObserver;
  using Pointer = itk::SmartPointer<Self>;
  itkNewMacro(Self);

  void Execute(itk::Object*, const itk::EventObject&) override { this->Count(); }
  void Execute(const itk::Object*, const itk::EventObject&) override { this->Count(); }

  LoadObserver observer;

private:
  void Count()
  {
    ++this->steps;
    if (this->observer &&
      !this->observer(std::min(1.0, double(this->steps) / (Levels * StepsPerLevel))))
    {
      throw Cancelled();
    }
  }

  int steps = 0;
};

Optimizer::Pointer NewOptimizer(Metric* metric, const LoadObserver& observer)
{
  auto scales = itk::RegistrationParameterScalesFromPhysicalShift<Metric>::New();
  scales->SetMetric(metric);
  auto optimizer = Optimizer::New();
  optimizer->SetScalesEstimator(scales);
  optimizer->SetDoEstimateLearningRateOnce(true);
  optimizer->SetNumberOfIterations(StepsPerLevel);
  optimizer->SetMinimumStepLength(0.002);
  optimizer->SetRelaxationFactor(0.6);
  optimizer->SetReturnBestParametersAndValue(true);
  auto steps = StepObserver::New();
  steps->observer = observer;
  optimizer->AddObserver(itk::IterationEvent(), steps);
  return optimizer;
}

Method::Pointer NewMethod(Image* fixed, Image* moving, Transform* start)
{
  auto metric = Metric::New();
  metric->SetNumberOfHistogramBins(Bins);
  auto method = Method::New();
  method->SetFixedImage(fixed);
  method->SetMovingImage(moving);
  method->SetMetric(metric);
  method->SetInitialTransform(start);
  method->InPlaceOn();
  method->SetNumberOfLevels(Levels);
  Method::ShrinkFactorsArrayType shrink(Levels);
  Method::SmoothingSigmasArrayType sigmas(Levels);
  for (int level = 0; level < Levels; ++level)
  {
    shrink[level] = 1 << (Levels - 1 - level);
    sigmas[level] = 0.5 * (double(shrink[level]) - 1.0);
  }
  method->SetShrinkFactorsPerLevel(shrink);
  method->SetSmoothingSigmasPerLevel(sigmas);
  method->SetSmoothingSigmasAreSpecifiedInPhysicalUnits(false);
  method->SetMetricSamplingStrategy(Method::MetricSamplingStrategyEnum::RANDOM);
  method->SetMetricSamplingPercentage(SampledPart);
  method->MetricSamplingReinitializeSeed(Seed);
  return method;
}

}

Placement RegisteredPlacement(
  vtkImageData* fixed, vtkImageData* moving, const Placement& start, const LoadObserver& observer)
{
  const glm::dmat4 worldFromPatient = WorldFromPatient(start, moving);
  const glm::dvec3 center(worldFromPatient * glm::dvec4(VectorOf(MiddleOf(moving)), 1.0));
  const Transform::Pointer transform = TransformOf(glm::inverse(worldFromPatient), center);
  const Image::Pointer fixedImage = ItkImageOf(fixed);
  const Image::Pointer movingImage = ItkImageOf(moving);
  const Method::Pointer method = NewMethod(fixedImage, movingImage, transform);
  auto* const metric = dynamic_cast<Metric*>(method->GetModifiableMetric());
  const Optimizer::Pointer optimizer = NewOptimizer(metric, observer);
  method->SetOptimizer(optimizer);
  try
  {
    method->Update();
  }
  catch (const Cancelled&)
  {
    throw std::runtime_error("The registration was stopped");
  }
  catch (const itk::ExceptionObject& problem)
  {
    throw std::runtime_error(
      std::string("The volumes cannot be registered: expected volumes that overlap; move one over "
                  "the other first. ITK says: ") +
      problem.GetDescription());
  }
  return PlacementOf(glm::inverse(MotionOf(*transform)), moving);
}

}
