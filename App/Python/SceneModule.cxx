// The extension module varimarch._scene, which renders scenes for Python by the pipeline of
// App/Scene. Presets and scenes are passed as the JSON text of Documentation/SceneFormat.md.
#include "vtkPython.h" // Python's header must come first

#include "Readers/VtkMessages.h"
#include "Scene/LookJson.h"
#include "Scene/OffscreenView.h"
#include "Scene/Presets.h"
#include "Scene/SceneFile.h"
#include "Scene/VolumeProperty.h"

#include <nlohmann/json.hpp>
#include <vtkPythonUtil.h>

#include <mutex>
#include <stdexcept>

namespace varimarch
{

namespace
{

std::mutex rendering;

// Scope guard that releases Python's interpreter, so that other threads can run. Only one thread
// renders at a time, because VTK is not thread-safe.
class ReleasedInterpreter
{
public:
  ReleasedInterpreter() = default;
  ~ReleasedInterpreter() { PyEval_RestoreThread(this->state); }
  ReleasedInterpreter(const ReleasedInterpreter&) = delete;
  void operator=(const ReleasedInterpreter&) = delete;

private:
  PyThreadState* state = PyEval_SaveThread();
  std::lock_guard<std::mutex> lock{ rendering };
};

// Returns the result of a function. Its exceptions become Python's: a ValueError for wrong
// arguments, otherwise a RuntimeError.
template <class Function>
PyObject* ResultOf(const Function& function)
{
  try
  {
    return function();
  }
  catch (const std::invalid_argument& error)
  {
    PyErr_SetString(PyExc_ValueError, error.what());
  }
  catch (const std::exception& error)
  {
    PyErr_SetString(PyExc_RuntimeError, error.what());
  }
  return nullptr;
}

// The arguments of the functions that read a volume.
struct VolumeAndText
{
  vtkImageData* volume = nullptr;
  const char* text = nullptr;

  /// Returns false and sets a Python error if the arguments have other types.
  bool Take(PyObject* arguments)
  {
    PyObject* object = nullptr;
    if (!PyArg_ParseTuple(arguments, "Os", &object, &this->text))
    {
      return false;
    }
    this->volume =
      static_cast<vtkImageData*>(vtkPythonUtil::GetPointerFromObject(object, "vtkImageData"));
    return this->volume != nullptr;
  }
};

PyObject* Presets(PyObject*, PyObject*)
{
  return ResultOf(
    []
    {
      nlohmann::ordered_json presets;
      for (const std::string& name : PresetNames())
      {
        presets[name] = JsonFromPreset(BuiltInPreset(name));
      }
      return PyUnicode_FromString(TextFromJson(presets).c_str());
    });
}

PyObject* PresetInUnitsOfData(PyObject*, PyObject* arguments)
{
  VolumeAndText given;
  if (!given.Take(arguments))
  {
    return nullptr;
  }
  return ResultOf(
    [&given]
    {
      Preset preset = PresetFromText(given.text, "preset");
      preset.look = InUnitsOfData(preset.look, given.volume);
      return PyUnicode_FromString(PresetText(preset).c_str());
    });
}

vtkSmartPointer<vtkImageData> RenderScene(
  const Scene& scene, vtkImageData* volume, VtkMessages& messages)
{
  const ReleasedInterpreter released;
  OffscreenView view(scene, volume, MapperKind::Varimarch);
  messages.Take(view.Pipeline().Mapper());
  messages.Take(view.Pipeline().Renderer());
  messages.Take(view.Pipeline().Renderer()->GetRenderWindow());
  view.Render();
  return view.Bytes();
}

Scene SceneFromArgument(const char* text)
{
  try
  {
    return SceneWithoutVolumeFromText(text, "scene");
  }
  catch (const std::runtime_error& error)
  {
    throw std::invalid_argument(error.what());
  }
}

PyObject* Render(PyObject*, PyObject* arguments)
{
  VolumeAndText given;
  if (!given.Take(arguments))
  {
    return nullptr;
  }
  return ResultOf(
    [&given]() -> PyObject*
    {
      VtkMessages messages;
      const auto image = RenderScene(SceneFromArgument(given.text), given.volume, messages);
      for (const std::string& warning : messages.Warnings())
      {
        // Level 1 is render(), level 2 its caller.
        if (PyErr_WarnEx(PyExc_RuntimeWarning, warning.c_str(), 2) != 0)
        {
          return nullptr;
        }
      }
      if (!messages.Errors().empty())
      {
        throw std::runtime_error(messages.Errors().front());
      }
      return vtkPythonUtil::GetObjectFromPointer(image);
    });
}

}

}

PyMODINIT_FUNC PyInit__scene()
{
  static PyMethodDef functions[] = { { "presets", varimarch::Presets, METH_NOARGS,
                                       "() -> JSON text with all presets by their names." },
    { "in_units_of_data", varimarch::PresetInUnitsOfData, METH_VARARGS,
      "(volume, preset) -> the preset with values in the units of the volume's data." },
    { "render", varimarch::Render, METH_VARARGS,
      "(volume, scene) -> the rendered vtkImageData, whose first row is the lowest." },
    { nullptr, nullptr, 0, nullptr } };
  static PyModuleDef module = { PyModuleDef_HEAD_INIT, "_scene",
    "Renders scenes as the program varimarch does.", -1, functions, nullptr, nullptr, nullptr,
    nullptr };
  PyObject* const created = PyModule_Create(&module);
  if (created && PyModule_AddStringConstant(created, "version", VARIMARCH_VERSION) != 0)
  {
    Py_DECREF(created);
    return nullptr;
  }
  return created;
}
