#include "vtkVarimarchVolumeRepresentation.h"

#include "OwnedPart.h"
#include "ScalarsOfLook.h"

#include "vtkAbstractVolumeMapper.h"
#include "vtkBoundingBox.h"
#include "vtkColorTransferFunction.h"
#include "vtkCommand.h"
#include "vtkCommunicator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPVLODVolume.h"
#include "vtkPVLogger.h"
#include "vtkPVRenderView.h"
#include "vtkRectilinearGrid.h"
#include "vtkRenderer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkVariationFieldVolumeMapper.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <vector>

namespace
{

bool HasSeveralProcesses()
{
  vtkMultiProcessController* const controller = vtkMultiProcessController::GetGlobalController();
  return controller && controller->GetNumberOfProcesses() > 1;
}

// The pipeline's information about a grid that is not a piece of another.
vtkSmartPointer<vtkInformation> InformationOf(vtkDataSet* grid)
{
  auto information = vtkSmartPointer<vtkInformation>::New();
  information->Set(vtkDataObject::DATA_OBJECT(), grid);
  if (auto* const image = vtkImageData::SafeDownCast(grid))
  {
    information->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), image->GetExtent(), 6);
  }
  return information;
}

// True for blend modes whose parts of a ray can be laid over each other.
bool IsComposite(int blendMode)
{
  return blendMode == vtkVolumeMapper::COMPOSITE_BLEND ||
    blendMode == vtkVolumeMapper::ISOSURFACE_BLEND || blendMode == vtkVolumeMapper::SLICE_BLEND;
}

}

vtkStandardNewMacro(vtkVarimarchVolumeRepresentation);

vtkVarimarchVolumeRepresentation::vtkVarimarchVolumeRepresentation()
  : Mapper(vtkVariationFieldVolumeMapper::New())
{
  this->VolumeMapper.TakeReference(this->Mapper);
  // This width is 1 but for rounding. It limits premultiplied colours to the opacity, as light may
  // exceed it: ParaView adds the parts of a picture in 8 bits, in which a sum above 255 begins at
  // 0.
  this->Mapper->SetFinalColorWindow(1.0F + 1e-6F);
}

vtkVarimarchVolumeRepresentation::~vtkVarimarchVolumeRepresentation() = default;

void vtkVarimarchVolumeRepresentation::SetErrorTolerance(double tolerance)
{
  this->Mapper->SetErrorTolerance(tolerance);
}

void vtkVarimarchVolumeRepresentation::SetAccelerationMode(int mode)
{
  this->Mapper->SetAccelerationMode(mode);
}

void vtkVarimarchVolumeRepresentation::SetShadows(bool shadows)
{
  this->Mapper->SetShadows(shadows);
}

void vtkVarimarchVolumeRepresentation::SetBlendMode(int blendMode)
{
  this->Mapper->SetBlendMode(blendMode);
}

void vtkVarimarchVolumeRepresentation::SetCropping(int cropping)
{
  this->Cropping = cropping != 0;
}

void vtkVarimarchVolumeRepresentation::SetVolumetricScatteringBlending(float blending)
{
  if (blending > 0.0F)
  {
    vtkWarningMacro("VolumetricScatteringBlending is "
      << blending << ", but \"Volume (Varimarch)\" does not scatter: expected 0; switch its "
      << "shadows on instead, or choose ParaView's \"Volume\"");
  }
}

void vtkVarimarchVolumeRepresentation::SetPosition(double x, double y, double z)
{
  this->Superclass::SetPosition(x, y, z);
  this->MarkModified();
}

void vtkVarimarchVolumeRepresentation::SetOrientation(double x, double y, double z)
{
  this->Superclass::SetOrientation(x, y, z);
  this->MarkModified();
}

void vtkVarimarchVolumeRepresentation::SetScale(double x, double y, double z)
{
  this->Superclass::SetScale(x, y, z);
  this->MarkModified();
}

void vtkVarimarchVolumeRepresentation::SetOrigin(double x, double y, double z)
{
  this->Superclass::SetOrigin(x, y, z);
  this->MarkModified();
}

// The box around the part of this process. ParaView's representation gives the view the box before
// the volume is turned, and the view then composites the parts in a wrong order. Rounding must not
// make boxes that touch overlap, because the view finds no order for those.
void vtkVarimarchVolumeRepresentation::BoundsInWorld(double bounds[6])
{
  const vtkBoundingBox box(this->DataBounds);
  vtkBoundingBox turned;
  for (int corner = 0; box.IsValid() && corner < 8; ++corner)
  {
    double position[4] = { 0.0, 0.0, 0.0, 1.0 };
    box.GetCorner(corner, position);
    this->Actor->GetMatrix()->MultiplyPoint(position, position);
    turned.AddPoint(position);
  }
  constexpr double Gap = 1e-6;
  turned.ScaleAboutCenter(1.0 - Gap);
  turned.GetBounds(bounds);
}

int vtkVarimarchVolumeRepresentation::ProcessViewRequest(
  vtkInformationRequestKey* request, vtkInformation* input, vtkInformation* output)
{
  const int result = this->Superclass::ProcessViewRequest(request, input, output);
  if (result && request == vtkPVView::REQUEST_UPDATE())
  {
    double bounds[6];
    this->BoundsInWorld(bounds);
    vtkPVRenderView::SetGeometryBounds(input, this, bounds);
  }
  return result;
}

int vtkVarimarchVolumeRepresentation::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  const int result = this->Superclass::RequestUpdateExtent(request, inputs, outputs);
  for (int i = 0; HasSeveralProcesses() && i < inputs[0]->GetNumberOfInformationObjects(); ++i)
  {
    vtkInformation* const input = inputs[0]->GetInformationObject(i);
    if (vtkRectilinearGrid::GetData(input))
    {
      continue; // ParaView crops images to the cells of a process, but not these grids
    }
    vtkInformationIntegerKey* const levels =
      vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_GHOST_LEVELS();
    // Gradients at the faces of the part need the voxels behind them.
    input->Set(levels, std::max(1, input->Has(levels) ? input->Get(levels) : 0));
  }
  return result;
}

// Without a data set of several parts among the types, the pipeline would give its parts one after
// the other, and the last would be drawn.
int vtkVarimarchVolumeRepresentation::FillInputPortInformation(
  int port, vtkInformation* information)
{
  const int result = this->Superclass::FillInputPortInformation(port, information);
  information->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return result;
}

// Gives ParaView's representation the one grid that this process has, or none, in place of a data
// set of several parts. That representation crops an image to the cells that this process owns.
// This one keeps the image, and crops what is drawn.
int vtkVarimarchVolumeRepresentation::RequestData(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkNew<vtkInformationVector> grids;
  vtkInformationVector* inputsOfOne[] = { inputs[0] };
  auto* const parts = inputs[0]->GetNumberOfInformationObjects() == 1
    ? vtkCompositeDataSet::GetData(inputs[0], 0)
    : nullptr;
  this->HasParts = parts != nullptr;
  if (parts)
  {
    const std::vector<vtkDataSet*> found = varimarch::GridsIn(parts);
    this->Grids = found.size();
    vtkNew<vtkImageData> none;
    grids->Append(InformationOf(found.size() == 1 ? found.front() : none.Get()));
    inputsOfOne[0] = grids;
  }
  const int result = this->Superclass::RequestData(request, inputsOfOne, outputs);
  auto* const image = inputsOfOne[0]->GetNumberOfInformationObjects() == 1
    ? vtkImageData::GetData(inputsOfOne[0], 0)
    : nullptr;
  this->HasNeighbours = image && image->HasAnyGhostCells() && varimarch::IsAxisAligned(image) &&
    !this->UseSeparateOpacityArray;
  if (this->HasNeighbours)
  {
    this->Cache = varimarch::WithoutFlagsOfNeighbours(image);
  }
  return result;
}

// Crops to the cells that this process owns, and to the box that the user has set as parts of the
// whole volume.
void vtkVarimarchVolumeRepresentation::CropToOwnPart()
{
  this->Mapper->SetCropping(this->Cropping || this->HasNeighbours);
  double planes[6];
  std::copy_n(this->DataBounds, 6, planes);
  auto* const image = vtkImageData::SafeDownCast(this->Cache);
  for (int plane = 0; this->Cropping && plane < 6; ++plane)
  {
    const int axis = plane / 2;
    const double whole = image && varimarch::IsAxisAligned(image)
      ? image->GetOrigin()[axis] + image->GetSpacing()[axis] * this->WholeExtent[plane]
      : this->DataBounds[plane];
    const double place = this->CroppingOrigin[axis] + whole * this->CroppingScale[axis];
    planes[plane] =
      plane % 2 == 0 ? std::max(planes[plane], place) : std::min(planes[plane], place);
  }
  this->Mapper->SetCroppingRegionPlanes(planes);
}

// Replaces vectors by the scalars that a transfer function of one component maps.
void vtkVarimarchVolumeRepresentation::ChooseScalars()
{
  vtkDataSet* const data = this->Mapper->GetDataSetInput();
  int cellFlag = 0;
  vtkDataArray* const array = data
    ? vtkAbstractVolumeMapper::GetScalars(data, this->Mapper->GetScalarMode(),
        this->Mapper->GetArrayAccessMode(), this->Mapper->GetArrayId(),
        this->Mapper->GetArrayName(), cellFlag)
    : nullptr;
  if (!array || array->GetNumberOfComponents() == 1 || !this->Property->GetIndependentComponents())
  {
    return;
  }
  vtkColorTransferFunction* const look = this->Property->GetRGBTransferFunction(0);
  const std::string source = std::string(array->GetName() ? array->GetName() : "scalars") + " " +
    std::to_string(look->GetVectorMode()) + " " + std::to_string(look->GetVectorComponent());
  const std::string name = source + " of a vector";
  if (this->ScalarsSource != source || this->ScalarsTime != array->GetMTime())
  {
    this->Scalars = varimarch::ScalarsOfLook(array, look);
    this->Scalars->SetName(name.c_str());
    this->ScalarsSource = source;
    this->ScalarsTime = array->GetMTime();
  }
  vtkSmartPointer<vtkDataSet> copy;
  copy.TakeReference(data->NewInstance());
  copy->ShallowCopy(data);
  copy->GetAttributes(cellFlag == 0 ? vtkDataObject::POINT : vtkDataObject::CELL)
    ->AddArray(this->Scalars);
  this->Mapper->SetInputDataObject(copy);
  this->Mapper->SelectScalarArray(name.c_str());
}

// Lets all processes use the shortest steps that any of them needs. ParaView begins to render on
// all of them, also on those that then draw nothing, so that none waits for another in vain.
void vtkVarimarchVolumeRepresentation::AgreeOnSteps(vtkObject* caller, unsigned long, void*)
{
  auto* const view = vtkPVRenderView::SafeDownCast(this->GetView());
  if (!HasSeveralProcesses() || !this->GetVisibility() || !view ||
    !view->GetUseDistributedRenderingForRender())
  {
    return;
  }
  auto* const renderer = vtkRenderer::SafeDownCast(caller);
  vtkDataSet* const data = this->Mapper->GetDataSetInput();
  constexpr double Unlimited = VTK_DOUBLE_MAX;
  double distance = Unlimited;
  bool preIntegration = false;
  if (this->Actor->GetVisibility() && data && data->GetNumberOfPoints() > 0)
  {
    this->Part->SetMapper(this->Mapper);
    this->Part->SetProperty(this->Property);
    this->Part->SetUserMatrix(this->Actor->GetMatrix());
    this->Part->SetAllocatedRenderTime(renderer->GetAllocatedRenderTime(), renderer);
    this->Mapper->FindSteps(renderer, this->Part, distance, preIntegration);
  }
  // The least of both numbers of all processes; the second is -1 if any of them pre-integrates.
  const double own[] = { distance, preIntegration ? -1.0 : 0.0 };
  double least[2];
  vtkMultiProcessController::GetGlobalController()->AllReduce(
    own, least, 2, vtkCommunicator::MIN_OP);
  this->Mapper->SetCommonSteps(least[0] < Unlimited ? least[0] : 0.0, least[1] < 0.0);
  vtkVLogF(PARAVIEW_LOG_RENDERING_VERBOSITY(), "Varimarch: own steps %g, common steps %g%s", own[0],
    least[0], least[1] < 0.0 ? ", pre-integrated" : "");
}

bool vtkVarimarchVolumeRepresentation::AddToView(vtkView* view)
{
  if (auto* const renderView = vtkPVRenderView::SafeDownCast(view))
  {
    // After the observers that synchronize the cameras of processes.
    constexpr float Last = -1.0F;
    this->Observer = renderView->GetRenderer()->AddObserver(
      vtkCommand::StartEvent, this, &vtkVarimarchVolumeRepresentation::AgreeOnSteps, Last);
  }
  return this->Superclass::AddToView(view);
}

bool vtkVarimarchVolumeRepresentation::RemoveFromView(vtkView* view)
{
  if (auto* const renderView = vtkPVRenderView::SafeDownCast(view))
  {
    renderView->GetRenderer()->RemoveObserver(this->Observer);
  }
  return this->Superclass::RemoveFromView(view);
}

// A sentence that says why this process cannot draw its part; empty if it can.
std::string vtkVarimarchVolumeRepresentation::Problem()
{
  if (HasSeveralProcesses() && !IsComposite(this->Mapper->GetBlendMode()))
  {
    return std::string("The blend mode is ") + std::to_string(this->Mapper->GetBlendMode()) +
      ", whose value of a pixel needs the whole ray, but several processes have a part of it each: "
      "expected composite (0), isosurface (5) or slice (6), or one process";
  }
  if (HasSeveralProcesses() && this->Mapper->GetShadows())
  {
    return "Shadows are on, but a process does not have the parts of the volume between its own "
           "and "
           "a light: expected shadows off, or one process";
  }
  if (this->HasParts && this->Grids > 1)
  {
    return "The input has " + std::to_string(this->Grids) +
      " images and rectilinear grids in this process: expected one; extract one of them, or choose "
      "ParaView's \"Volume\"";
  }
  if (this->HasParts && this->Cropping && HasSeveralProcesses())
  {
    return "Cropping is on, but a process does not know the whole of which its image is a part: "
           "expected no cropping, one process, or an image that a reader has divided";
  }
  return std::string();
}

void vtkVarimarchVolumeRepresentation::UpdateMapperParameters()
{
  this->Mapper->SetCropping(0); // the planes are set below
  this->Superclass::UpdateMapperParameters();
  const std::string problem = this->Problem();
  if (this->ReportedProblem != problem)
  {
    this->ReportedProblem = problem;
    if (!problem.empty())
    {
      vtkErrorMacro(<< problem << ".");
    }
  }
  if (!problem.empty())
  {
    this->Actor->SetVisibility(0);
    return;
  }
  this->CropToOwnPart();
  this->ChooseScalars();
}

void vtkVarimarchVolumeRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Cropping: " << this->Cropping << "\n";
  os << indent << "HasNeighbours: " << this->HasNeighbours << "\n";
  os << indent << "Mapper:\n";
  this->Mapper->PrintSelf(os, indent.GetNextIndent());
}
