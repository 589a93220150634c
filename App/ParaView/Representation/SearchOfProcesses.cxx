#include "SearchOfProcesses.h"

#include "vtkCommunicator.h"
#include "vtkFloatArray.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace varimarch
{

namespace
{

constexpr int Leader = 0;
constexpr int Tag = 4801;

void Send(vtkMultiProcessController* controller, std::vector<float>& image, int process)
{
  vtkNew<vtkFloatArray> array;
  constexpr int DoNotDelete = 1;
  array->SetArray(image.data(), vtkIdType(image.size()), DoNotDelete);
  controller->Send(array, process, Tag);
}

std::vector<float> Received(vtkMultiProcessController* controller, int process)
{
  vtkNew<vtkFloatArray> array;
  controller->Receive(array, process, Tag);
  const float* const begin = array->GetPointer(0);
  return std::vector<float>(begin, begin + array->GetNumberOfValues());
}

// Lays neighbours in the order over each other, then neighbours of the results, and so on. The
// frontmost process has the whole in the end, which it gives to the leader.
std::vector<float> LaidOverByAll(
  vtkMultiProcessController* controller, const std::vector<int>& order, std::vector<float> image)
{
  const int self = controller->GetLocalProcessId();
  const auto place = std::size_t(std::find(order.begin(), order.end(), self) - order.begin());
  for (std::size_t step = 1; step < order.size(); step *= 2)
  {
    if (place % (2 * step) != 0)
    {
      Send(controller, image, order[place - step]);
      break;
    }
    if (place + step < order.size())
    {
      image = LaidOver(std::move(image), Received(controller, order[place + step]));
    }
  }
  if (order.front() != Leader && self == order.front())
  {
    Send(controller, image, Leader);
  }
  return order.front() != Leader && self == Leader ? Received(controller, order.front()) : image;
}

}

SearchingProcesses SearchOfProcesses(vtkMultiProcessController* controller, std::vector<int> order)
{
  const auto takeLeast = [controller](std::vector<double>& numbers)
  {
    const std::vector<double> own = numbers;
    controller->AllReduce(
      own.data(), numbers.data(), vtkIdType(own.size()), vtkCommunicator::MIN_OP);
  };
  const auto takeFromLeader = [controller](std::vector<double>& numbers)
  { controller->Broadcast(numbers.data(), vtkIdType(numbers.size()), Leader); };
  const auto layOver = [controller, order = std::move(order)](std::vector<float> own)
  { return LaidOverByAll(controller, order, std::move(own)); };
  return { controller->GetLocalProcessId() == Leader, takeLeast, takeFromLeader, layOver };
}

}
