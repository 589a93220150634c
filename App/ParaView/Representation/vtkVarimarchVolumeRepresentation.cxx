#include "vtkVarimarchVolumeRepresentation.h"

#include "ImageOfProcesses.h"
#include "OrderOfProcesses.h"
#include "OwnedPart.h"
#include "Refusals.h"
#include "SearchOfProcesses.h"
#include "vtkVarimarchPartsMapper.h"

#include "vtkCommand.h"
#include "vtkCompositeDataSet.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMatrix3x3.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkOutlineSource.h"
#include "vtkPVLODVolume.h"
#include "vtkPVLogger.h"
#include "vtkPVRenderView.h"
#include "vtkRectilinearGrid.h"
#include "vtkRenderer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace
{

// A width of 1 but for rounding, which limits premultiplied colours to the opacity, as light may
// exceed it: ParaView adds the parts of a picture in 8 bits, in which a sum above 255 begins at 0.
constexpr float LimitingWindow = 1.0F + 1e-6F;

bool HasSeveralProcesses()
{
  vtkMultiProcessController* const controller = vtkMultiProcessController::GetGlobalController();
  return controller && controller->GetNumberOfProcesses() > 1;
}

bool IsFirstProcess()
{
  vtkMultiProcessController* const controller = vtkMultiProcessController::GetGlobalController();
  return !controller || controller->GetLocalProcessId() == 0;
}

}

vtkStandardNewMacro(vtkVarimarchVolumeRepresentation);

vtkVarimarchVolumeRepresentation::vtkVarimarchVolumeRepresentation()
  : Mapper(vtkVarimarchPartsMapper::New())
  , Image(std::make_unique<varimarch::ImageOfProcesses>())
{
  this->VolumeMapper.TakeReference(this->Mapper);
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

void vtkVarimarchVolumeRepresentation::SetShadowStrength(double strength)
{
  this->Mapper->SetShadowStrength(strength);
}

void vtkVarimarchVolumeRepresentation::SetAmbientOcclusion(double strength)
{
  this->Mapper->SetAmbientOcclusion(strength);
}

void vtkVarimarchVolumeRepresentation::SetFloatCompositing(bool floats)
{
  this->FloatCompositing = floats;
}

void vtkVarimarchVolumeRepresentation::SetFloatImageFile(const char* file)
{
  this->Image->SetFile(file ? file : "");
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
  this->Mapper->SetVolumetricScatteringBlending(blending);
}

void vtkVarimarchVolumeRepresentation::SetGlobalIlluminationReach(float reach)
{
  this->Mapper->SetGlobalIlluminationReach(reach);
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

int vtkVarimarchVolumeRepresentation::ProcessViewRequest(
  vtkInformationRequestKey* request, vtkInformation* input, vtkInformation* output)
{
  const int result = this->Superclass::ProcessViewRequest(request, input, output);
  if (result && request == vtkPVView::REQUEST_UPDATE())
  {
    double bounds[6];
    varimarch::TurnBounds(this->DataBounds, this->Actor->GetMatrix(), bounds);
    vtkPVRenderView::SetGeometryBounds(input, this, bounds);
    varimarch::KeepDataBox(this->DataBounds, this->Actor);
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
    // A step at a face of the part may end a voxel behind it, where gradients need another one.
    input->Set(levels, std::max(2, input->Has(levels) ? input->Get(levels) : 0));
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

// Gives ParaView's representation one grid, or none, in place of a data set of several parts. That
// representation crops an image to the cells that this process owns; this one keeps the voxels
// around them, and crops what is drawn.
int vtkVarimarchVolumeRepresentation::RequestData(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  const bool hasInput = inputs[0]->GetNumberOfInformationObjects() == 1;
  vtkDataObject* const data = hasInput ? vtkDataObject::GetData(inputs[0], 0) : nullptr;
  const std::vector<vtkDataSet*> grids = varimarch::GridsIn(data);
  this->HasBlocks = vtkCompositeDataSet::SafeDownCast(data) != nullptr;
  vtkNew<vtkInformationVector> one;
  vtkInformationVector* inputsOfOne[] = { inputs[0] };
  if (this->HasBlocks)
  {
    vtkNew<vtkImageData> none;
    one->Append(varimarch::InformationOf(grids.empty() ? none.Get() : grids.front()));
    inputsOfOne[0] = one;
  }
  const int result = this->Superclass::RequestData(request, inputsOfOne, outputs);
  std::vector<varimarch::OwnedPart> parts;
  for (vtkDataSet* grid : grids)
  {
    parts.push_back(varimarch::PartOf(grid));
    if (this->UseSeparateOpacityArray)
    {
      this->AppendOpacityComponent(parts.back().data);
    }
  }
  this->Mapper->SetParts(parts);
  this->Mapper->GetBounds(this->DataBounds);
  if (!parts.empty())
  {
    this->OutlineSource->SetBounds(this->DataBounds);
    this->OutlineSource->Update();
  }
  return result;
}

// Crops to the box that the user has set as parts of the whole volume.
void vtkVarimarchVolumeRepresentation::CropToBox()
{
  this->Mapper->SetCropping(this->Cropping);
  double planes[6];
  auto* const image = vtkImageData::SafeDownCast(this->Cache);
  const bool isPiece = image && !this->HasBlocks && image->GetDirectionMatrix()->IsIdentity();
  for (int plane = 0; plane < 6; ++plane)
  {
    const int axis = plane / 2;
    const double whole = isPiece
      ? image->GetOrigin()[axis] + image->GetSpacing()[axis] * this->WholeExtent[plane]
      : this->DataBounds[plane];
    planes[plane] = this->CroppingOrigin[axis] + whole * this->CroppingScale[axis];
  }
  this->Mapper->SetCroppingRegionPlanes(planes);
}

// Finds the steps of all parts, on all processes, and the order of processes. ParaView begins to
// render on all processes, also on those that then draw nothing, so that none waits for another in
// vain.
void vtkVarimarchVolumeRepresentation::AgreeWithOthers(vtkObject* caller, unsigned long, void*)
{
  if (!this->GetVisibility())
  {
    return;
  }
  auto* const renderer = vtkRenderer::SafeDownCast(caller);
  auto* const view = vtkPVRenderView::SafeDownCast(this->GetView());
  vtkMultiProcessController* const controller = vtkMultiProcessController::GetGlobalController();
  varimarch::SearchingProcesses processes = varimarch::SearchingProcesses::Single();
  std::optional<varimarch::OwnerOrder> order;
  if (HasSeveralProcesses() && view && view->GetUseDistributedRenderingForRender())
  {
    order = varimarch::OrderOfProcesses(renderer, controller);
    processes = varimarch::SearchOfProcesses(controller, order->owners);
  }
  vtkVarimarchVolumeRepresentation* const first = FirstVisibleIn(view);
  const bool inFloats =
    first && first->FloatCompositing && varimarch::ImageOfProcesses::MayBeInFloats(renderer);
  this->Mapper->SetFinalColorWindow(order && !inFloats ? LimitingWindow : 1.0F);
  this->Part->SetMapper(this->Mapper);
  this->Part->SetProperty(this->Property);
  this->Part->SetUserMatrix(this->Actor->GetMatrix());
  this->Part->ComputeMatrix();
  this->Part->SetAllocatedRenderTime(renderer->GetAllocatedRenderTime(), renderer);
  this->Part->SetVisibility(this->Actor->GetVisibility());
  const auto steps = this->Mapper->FindSteps(renderer, this->Part, processes);
  if (first == this)
  {
    this->BeginImage(renderer, order, inFloats);
  }
  vtkVLogF(PARAVIEW_LOG_RENDERING_VERBOSITY(), "Varimarch: common steps %g%s",
    steps ? steps->step.sampleDistance : 0.0,
    steps && steps->isPreIntegrated ? ", pre-integrated" : "");
}

// The first visible volume of this kind in a view, null if there is none.
vtkVarimarchVolumeRepresentation* vtkVarimarchVolumeRepresentation::FirstVisibleIn(
  vtkPVRenderView* view)
{
  for (int i = 0; view && i < view->GetNumberOfRepresentations(); ++i)
  {
    auto* const volume = SafeDownCast(view->GetRepresentation(i));
    if (volume && volume->GetVisibility())
    {
      return volume;
    }
  }
  return nullptr;
}

// Begins the image of the view. All processes take part.
// @param order  of the pictures of processes; none if this one draws without others
void vtkVarimarchVolumeRepresentation::BeginImage(
  vtkRenderer* renderer, const std::optional<varimarch::OwnerOrder>& order, bool inFloats)
{
  if (!order)
  {
    if (inFloats)
    {
      this->Image->BeginAlone(renderer);
    }
    return;
  }
  vtkMultiProcessController* const controller = vtkMultiProcessController::GetGlobalController();
  const std::string warning = this->Image->Begin(renderer, controller, *order, inFloats);
  if (!warning.empty() && IsFirstProcess())
  {
    vtkWarningMacro(<< warning);
  }
}

void vtkVarimarchVolumeRepresentation::EndImage(vtkObject*, unsigned long, void*)
{
  this->Image->End();
}

bool vtkVarimarchVolumeRepresentation::AddToView(vtkView* view)
{
  if (auto* const renderView = vtkPVRenderView::SafeDownCast(view))
  {
    // After the observers that synchronize the cameras of processes.
    constexpr float Last = -1.0F;
    vtkRenderer* const renderer = renderView->GetRenderer();
    this->StartObserver = renderer->AddObserver(
      vtkCommand::StartEvent, this, &vtkVarimarchVolumeRepresentation::AgreeWithOthers, Last);
    this->EndObserver = renderer->AddObserver(
      vtkCommand::EndEvent, this, &vtkVarimarchVolumeRepresentation::EndImage);
  }
  return this->Superclass::AddToView(view);
}

bool vtkVarimarchVolumeRepresentation::RemoveFromView(vtkView* view)
{
  if (auto* const renderView = vtkPVRenderView::SafeDownCast(view))
  {
    renderView->GetRenderer()->RemoveObserver(this->StartObserver);
    renderView->GetRenderer()->RemoveObserver(this->EndObserver);
  }
  return this->Superclass::RemoveFromView(view);
}

// True if light is dimmed by what it has passed.
bool vtkVarimarchVolumeRepresentation::DimsLight()
{
  return this->Mapper->GetShadows() || this->Mapper->GetAmbientOcclusion() > 0.0 ||
    this->Mapper->GetVolumetricScatteringBlending() > 0.0;
}

void vtkVarimarchVolumeRepresentation::UpdateMapperParameters()
{
  this->Mapper->SetCropping(0); // the planes are set below
  this->Superclass::UpdateMapperParameters();
  const varimarch::Request request{ this->Mapper->GetBlendMode(), this->DimsLight(), this->Cropping,
    HasSeveralProcesses(), this->HasBlocks };
  const std::string common = varimarch::ProblemOfRequest(request, this->Mapper->GetParts());
  const std::string problem =
    common.empty() ? varimarch::ProblemOfParts(this->Mapper->GetParts()) : common;
  if (this->ReportedProblem != problem)
  {
    this->ReportedProblem = problem;
    if (!problem.empty() && (common.empty() || IsFirstProcess()))
    {
      vtkErrorMacro(<< problem << ".");
    }
  }
  if (!problem.empty())
  {
    this->Actor->SetVisibility(0);
    return;
  }
  this->CropToBox();
}

void vtkVarimarchVolumeRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Cropping: " << this->Cropping << "\n";
  os << indent << "Mapper:\n";
  this->Mapper->PrintSelf(os, indent.GetNextIndent());
}
