// Asks ParaView for the order of many processes from the boxes that the plugin gives it, in views
// by chance, and prints the longest time [ms]. The exit code is 1 if an order is another one.

#include "OrderOfProcesses.h"

#include <vtkBoundingBox.h>
#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkOrderedCompositingHelper.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <numeric>
#include <random>
#include <vector>

namespace
{

// A camera somewhere in a world of any size.
void LookAround(vtkCamera* camera, std::mt19937& random)
{
  std::uniform_real_distribution<double> part(-1.0, 1.0);
  const double size = std::pow(10.0, 6.0 * part(random));
  camera->SetPosition(size * part(random), size * part(random), size * part(random));
  camera->SetFocalPoint(size * part(random), size * part(random), size * part(random));
  camera->SetParallelProjection(part(random) > 0.0);
}

}

int main()
{
  constexpr int Views = 5;
  std::mt19937 random(1);
  int wrong = 0;
  std::cout << "| processes | by chance [ms] | by their numbers [ms] |\n|---:|---:|---:|\n";
  for (int count : { 8, 64, 512, 1024 })
  {
    double longest[] = { 0.0, 0.0 };
    for (int view = 0; view < 2 * Views; ++view)
    {
      const bool isSorted = view % 2 == 1;
      std::vector<int> order(count);
      std::iota(order.begin(), order.end(), 0);
      if (!isSorted)
      {
        std::shuffle(order.begin(), order.end(), random);
      }
      vtkNew<vtkCamera> camera;
      LookAround(camera, random);
      vtkNew<vtkOrderedCompositingHelper> helper;
      helper->SetBoundingBoxes(varimarch::BoxesInOrder(order, camera));
      const auto begin = std::chrono::steady_clock::now();
      wrong += helper->ComputeSortOrder(camera) != order ? 1 : 0;
      const std::chrono::duration<double, std::milli> time =
        std::chrono::steady_clock::now() - begin;
      longest[isSorted] = std::max(longest[isSorted], time.count());
    }
    std::cout << "| " << count << " | " << longest[0] << " | " << longest[1] << " |\n";
  }
  std::cout << wrong << " orders are wrong\n";
  return wrong > 0 ? 1 : 0;
}
