// The program of libFuzzer. The environment variable VARIMARCH_FUZZ_TARGET names the target.
#include "Fuzz/FuzzTarget.h"

#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>

#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <string>

/// Ends the program at a message of VTK, which a user would see beside the reader's own.
class AbortingOutputWindow : public vtkOutputWindow
{
public:
  static AbortingOutputWindow* New();
  vtkTypeMacro(AbortingOutputWindow, vtkOutputWindow);

  void DisplayText(const char* text) override
  {
    // VTK lets nobody observe the elements of its XML files.
    if (std::string(text).find("vtkXMLDataElement") == std::string::npos)
    {
      std::cerr << "VTK printed: " << text << '\n';
      std::abort();
    }
  }
};

vtkStandardNewMacro(AbortingOutputWindow);

namespace
{

const varimarch::FuzzTarget& Target()
{
  static const varimarch::FuzzTarget target = []
  {
    const char* const name = std::getenv("VARIMARCH_FUZZ_TARGET");
    return varimarch::FuzzTargetNamed(name ? name : "");
  }();
  return target;
}

}

extern "C" int LLVMFuzzerInitialize(int*, char***)
{
  vtkNew<AbortingOutputWindow> window;
  vtkOutputWindow::SetInstance(window);
  try
  {
    Target();
  }
  catch (const std::exception& error)
  {
    std::cerr << "VARIMARCH_FUZZ_TARGET: " << error.what() << '\n';
    std::exit(2);
  }
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t byteCount)
{
  try
  {
    Target().run(std::string(reinterpret_cast<const char*>(bytes), byteCount));
  }
  catch (const std::exception& error)
  {
    std::cerr << "The target failed: " << error.what() << '\n';
    std::abort();
  }
  return 0;
}
