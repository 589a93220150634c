#include "vtkVarimarchVolumeRepresentation.h"

#include "Core/Blocks/BoxOverlap.h"
#include "OrderOfProcesses.h"
#include "OwnedPart.h"
#include "vtkVarimarchPartsMapper.h"

#include "vtkCommand.h"
#include "vtkCommunicator.h"
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
  : Mapper(vtkVarimarchPartsMapper::New())
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

void vtkVarimarchVolumeRepresentation::SetShadowStrength(double strength)
{
  this->Mapper->SetShadowStrength(strength);
}

void vtkVarimarchVolumeRepresentation::SetAmbientOcclusion(double strength)
{
  this->Mapper->SetAmbientOcclusion(strength);
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
    one->Append(InformationOf(grids.empty() ? none.Get() : grids.front()));
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

// Lets all parts, on all processes, use the shortest steps that any of them needs, and finds the
// order of processes. ParaView begins to render on all processes, also on those that then draw
// nothing, so that none waits for another in vain.
void vtkVarimarchVolumeRepresentation::AgreeWithOthers(vtkObject* caller, unsigned long, void*)
{
  auto* const view = vtkPVRenderView::SafeDownCast(this->GetView());
  const bool sharesProcesses =
    HasSeveralProcesses() && view && view->GetUseDistributedRenderingForRender();
  if (!this->GetVisibility())
  {
    return;
  }
  if (!sharesProcesses && this->Mapper->GetParts().size() < 2)
  {
    this->Mapper->SetCommonSteps(0.0, false); // it may have been one of several parts before
    return;
  }
  auto* const renderer = vtkRenderer::SafeDownCast(caller);
  constexpr double Unlimited = VTK_DOUBLE_MAX;
  double distance = Unlimited;
  bool preIntegration = false;
  if (this->Actor->GetVisibility())
  {
    this->Part->SetMapper(this->Mapper);
    this->Part->SetProperty(this->Property);
    this->Part->SetUserMatrix(this->Actor->GetMatrix());
    this->Part->SetAllocatedRenderTime(renderer->GetAllocatedRenderTime(), renderer);
    this->Mapper->FindSteps(renderer, this->Part, distance, preIntegration);
  }
  // The least of both numbers of all processes; the second is -1 if any of them pre-integrates.
  const double own[] = { distance, preIntegration ? -1.0 : 0.0 };
  double least[] = { own[0], own[1] };
  if (sharesProcesses)
  {
    vtkMultiProcessController::GetGlobalController()->AllReduce(
      own, least, 2, vtkCommunicator::MIN_OP);
    this->OrderProcesses(renderer);
  }
  this->Mapper->SetCommonSteps(least[0] < Unlimited ? least[0] : 0.0, least[1] < 0.0);
  vtkVLogF(PARAVIEW_LOG_RENDERING_VERBOSITY(), "Varimarch: own steps %g, common steps %g%s", own[0],
    least[0], least[1] < 0.0 ? ", pre-integrated" : "");
}

// Warns at the first view for which no order is right. All processes take part.
void vtkVarimarchVolumeRepresentation::OrderProcesses(vtkRenderer* renderer)
{
  vtkMultiProcessController* const controller = vtkMultiProcessController::GetGlobalController();
  const auto conflict = varimarch::OrderProcesses(renderer, controller);
  if (conflict && !this->HasWarnedOfOrder && controller->GetLocalProcessId() == 0)
  {
    vtkWarningMacro("The processes "
      << conflict->first << " and " << conflict->second
      << ", or others between them, have parts in front of each other, and ParaView, which lays "
         "the pictures of processes over each other as a whole, draws some pixels wrongly: no "
         "order of processes is right for this view; expected another view, one volume, or one "
         "process.");
  }
  this->HasWarnedOfOrder = this->HasWarnedOfOrder || conflict;
}

bool vtkVarimarchVolumeRepresentation::AddToView(vtkView* view)
{
  if (auto* const renderView = vtkPVRenderView::SafeDownCast(view))
  {
    // After the observers that synchronize the cameras of processes.
    constexpr float Last = -1.0F;
    this->Observer = renderView->GetRenderer()->AddObserver(
      vtkCommand::StartEvent, this, &vtkVarimarchVolumeRepresentation::AgreeWithOthers, Last);
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

// A sentence that says why this process cannot draw its parts; empty if it can.
std::string vtkVarimarchVolumeRepresentation::Problem()
{
  const std::vector<varimarch::OwnedPart>& parts = this->Mapper->GetParts();
  const bool isDivided = HasSeveralProcesses() || parts.size() > 1;
  if (isDivided && !IsComposite(this->Mapper->GetBlendMode()))
  {
    return std::string("The blend mode is ") + std::to_string(this->Mapper->GetBlendMode()) +
      ", whose value of a pixel needs the whole ray, but several processes or images have a part "
      "of it each: expected composite (0), isosurface (5) or slice (6), or one process and one "
      "image";
  }
  if (isDivided && this->DimsLight())
  {
    return "Shadows, ambient occlusion or scattering are on, but a process or image does not have "
           "the parts of the volume between its own and a light: expected them to be off, or one "
           "process and one image";
  }
  if (const auto overlap = varimarch::FirstOverlap(varimarch::BoxesOf(parts)))
  {
    return "The images " + std::to_string(overlap->first + 1) + " and " +
      std::to_string(overlap->second + 1) +
      " of the input overlap, so that no order to draw them in is right: expected images that "
      "touch at most; extract one of them, or choose ParaView's \"Volume\"";
  }
  if (this->HasBlocks && this->Cropping && HasSeveralProcesses())
  {
    return "Cropping is on, but a process does not know the whole of which its images are a part: "
           "expected no cropping, one process, or an image that a reader has divided";
  }
  return std::string();
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
  this->CropToBox();
}

void vtkVarimarchVolumeRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Cropping: " << this->Cropping << "\n";
  os << indent << "Mapper:\n";
  this->Mapper->PrintSelf(os, indent.GetNextIndent());
}
