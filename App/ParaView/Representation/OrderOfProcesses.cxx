#include "OrderOfProcesses.h"

#include "Frame/VolumeGeometry.h"

#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkCameraPass.h"
#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkIceTCompositePass.h"
#include "vtkImageProcessingPass.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleVectorKey.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPVDefaultPass.h"
#include "vtkRenderPass.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeCollection.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace varimarch
{

namespace
{

// A box of data that a process has, as numbers that processes exchange.
using Message = std::array<double, 23>;

Message MessageOf(const double bounds[6], vtkMatrix4x4* worldFromData, int process)
{
  Message message;
  std::copy_n(bounds, 6, message.begin());
  std::copy_n(worldFromData->GetData(), 16, message.begin() + 6);
  message.back() = process;
  return message;
}

OwnedBox OwnedBoxOf(const double* message)
{
  const glm::dmat4 worldFromData = glm::transpose(glm::make_mat4(message + 6));
  return { { { message[0], message[2], message[4] }, { message[1], message[3], message[5] } },
    worldFromData, int(message[22]) };
}

// The boxes of all visible volumes on this process. ParaView's volumes have none of their data, but
// one in the world.
vtkSmartPointer<vtkDoubleArray> OwnMessages(vtkRenderer* renderer, int process)
{
  auto messages = vtkSmartPointer<vtkDoubleArray>::New();
  vtkNew<vtkMatrix4x4> unmoved;
  vtkCollectionSimpleIterator iterator;
  vtkVolumeCollection* const volumes = renderer->GetVolumes();
  for (volumes->InitTraversal(iterator); vtkVolume* volume = volumes->GetNextVolume(iterator);)
  {
    vtkInformation* const keys = volume->GetPropertyKeys();
    const bool hasBox = keys && keys->Has(vtkDataObject::BOUNDING_BOX());
    const double* const bounds =
      hasBox ? keys->Get(vtkDataObject::BOUNDING_BOX()) : volume->GetBounds();
    if (volume->GetVisibility() && bounds && bounds[0] <= bounds[1])
    {
      for (double number : MessageOf(bounds, hasBox ? volume->GetMatrix() : unmoved, process))
      {
        messages->InsertNextValue(number);
      }
    }
  }
  return messages;
}

// The pass to which another one leaves the drawing; null for one that draws itself.
vtkRenderPass* DelegateOf(vtkRenderPass* pass)
{
  if (auto* const processing = vtkImageProcessingPass::SafeDownCast(pass))
  {
    return processing->GetDelegatePass();
  }
  auto* const camera = vtkCameraPass::SafeDownCast(pass);
  return camera ? camera->GetDelegatePass() : nullptr;
}

}

// ParaView's representation gives the view the box before the volume is turned.
void TurnBounds(const double bounds[6], vtkMatrix4x4* worldFromData, double turned[6])
{
  const vtkBoundingBox box(bounds);
  vtkBoundingBox around;
  for (int corner = 0; box.IsValid() && corner < 8; ++corner)
  {
    double position[4] = { 0.0, 0.0, 0.0, 1.0 };
    box.GetCorner(corner, position);
    worldFromData->MultiplyPoint(position, position);
    around.AddPoint(position);
  }
  constexpr double Gap = 1e-6;
  around.ScaleAboutCenter(1.0 - Gap);
  around.GetBounds(turned);
}

void KeepDataBox(const double bounds[6], vtkVolume* volume)
{
  vtkNew<vtkInformation> keys;
  keys->Set(vtkDataObject::BOUNDING_BOX(), bounds, 6);
  volume->SetPropertyKeys(keys);
}

OwnerOrder OrderOfProcesses(vtkRenderer* renderer, vtkMultiProcessController* controller)
{
  const auto own = OwnMessages(renderer, controller->GetLocalProcessId());
  vtkNew<vtkDoubleArray> all;
  controller->AllGatherV(own, all);
  std::vector<OwnedBox> boxes;
  for (vtkIdType i = 0; i < all->GetNumberOfValues(); i += vtkIdType(Message().size()))
  {
    boxes.push_back(OwnedBoxOf(all->GetPointer(i)));
  }
  OwnerOrder order =
    OwnersFrontToBack(boxes, controller->GetNumberOfProcesses(), ClipFromWorld(renderer));
  // All must have the same order, and the tiles of a display may differ in their view.
  controller->Broadcast(order.owners.data(), vtkIdType(order.owners.size()), 0);
  return order;
}

vtkIceTCompositePass* CompositePassOf(vtkRenderer* renderer)
{
  vtkRenderPass* pass = renderer->GetPass();
  while (vtkRenderPass* const delegate = DelegateOf(pass))
  {
    pass = delegate;
  }
  return vtkIceTCompositePass::SafeDownCast(pass);
}

vtkCameraPass* UsualCameraPassOf(vtkRenderer* renderer)
{
  vtkRenderPass* above = nullptr;
  vtkRenderPass* pass = renderer->GetPass();
  while (vtkRenderPass* const delegate = DelegateOf(pass))
  {
    above = pass;
    pass = delegate;
  }
  return vtkPVDefaultPass::SafeDownCast(pass) ? vtkCameraPass::SafeDownCast(above) : nullptr;
}

// ParaView knows an order of boxes that touch or overlap, by their centres along the axis in which
// the overlap is thinnest, and looks for the nearest box by comparing each with all others until it
// finds a nearer one. Boxes that only touched their neighbours in the row would be compared with
// nearly all others before that.
std::vector<vtkBoundingBox> BoxesInOrder(const std::vector<int>& processes, vtkCamera* camera)
{
  const double* const direction = camera->GetDirectionOfProjection();
  const double* const eye = camera->GetPosition();
  const auto isShorter = [](double a, double b) { return std::abs(a) < std::abs(b); };
  const auto axis = std::max_element(direction, direction + 3, isShorter) - direction;
  // A step that is large enough for the digits of a number. ParaView compares lengths as integers.
  const double step = std::max(1.0, 1e-6 * std::abs(*std::max_element(eye, eye + 3, isShorter)));
  const double length = 2.0 * step * double(processes.size());
  const double width = 2.0 * length;
  std::vector<vtkBoundingBox> boxes(processes.size());
  for (std::size_t place = 0; place < processes.size(); ++place)
  {
    std::array<double, 3> near{ eye[0] - width, eye[1] - width, eye[2] - width };
    std::array<double, 3> far{ eye[0] + width, eye[1] + width, eye[2] + width };
    near[axis] = eye[axis] + std::copysign(step * double(place + 1), direction[axis]);
    far[axis] = near[axis] + std::copysign(length, direction[axis]);
    boxes[processes[place]].AddPoint(near.data());
    boxes[processes[place]].AddPoint(far.data());
  }
  return boxes;
}

}
