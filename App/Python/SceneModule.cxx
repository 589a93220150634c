// The extension module varimarch._scene, which renders scenes for Python by the pipeline of
// App/Scene. Presets and scenes are passed as the JSON text of Documentation/SceneFormat.md.
#include "vtkPython.h" // Python's header must come first

#include "Readers/Parsing/VtkMessages.h"
#include "Scene/Images/OffscreenView.h"
#include "Scene/Json/JsonCursor.h"
#include "Scene/Json/SceneFile.h"
#include "Scene/Json/SceneFormat.h"
#include "Scene/Json/SceneNames.h"
#include "Scene/Looks/Presets.h"
#include "Scene/Looks/VolumeProperty.h"
#include "Scene/Segments/LabelMap.h"
#include "Scene/Volumes/VariationImage.h"

#include <nlohmann/json.hpp>
#include <vtkPythonUtil.h>

#include <algorithm>
#include <memory>
#include <mutex>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

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
  catch (const std::bad_alloc&)
  {
    PyErr_NoMemory();
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

PyObject* Settings(PyObject*, PyObject*)
{
  return ResultOf(
    []
    {
      nlohmann::ordered_json settings;
      for (const auto& [path, field] : SceneSettings())
      {
        if (field.isArgument)
        {
          settings[field.option] = { { "path", path }, { "meaning", field.meaning },
            { "unit", field.unit }, { "usual", field.usual }, { "schema", field.schema } };
        }
      }
      return PyUnicode_FromString(TextFromJson(settings).c_str());
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

// The arguments of render() for labels.
struct GivenLabels
{
  std::string path;                    ///< empty if the labels are an image
  vtkSmartPointer<vtkImageData> image; ///< null if the labels are a file
  const char* segments = "[]";
  double opacity = 1.0;

  /// Returns false and sets a Python error if the object is neither a path nor an image.
  bool Take(PyObject* object)
  {
    if (PyUnicode_Check(object))
    {
      const char* const text = PyUnicode_AsUTF8(object);
      this->path = text ? text : "";
      return text != nullptr;
    }
    this->image =
      static_cast<vtkImageData*>(vtkPythonUtil::GetPointerFromObject(object, "vtkImageData"));
    return this->image != nullptr;
  }
};

// The labels on the grid of a volume; null without any.
std::shared_ptr<const LabelMap> LabelsOver(vtkImageData* volume, const GivenLabels& given)
{
  if (given.path.empty() && !given.image)
  {
    return nullptr;
  }
  LoadedVolume scan;
  scan.image = volume;
  LoadedVolume labels;
  labels.image = given.image;
  auto map = std::make_shared<LabelMap>(
    given.image ? LabelMapOf(labels, "the array", scan) : LoadLabels({ given.path }, scan));
  for (Segment& segment : map->segments)
  {
    segment.opacity = given.opacity;
  }
  TakeAppearance(
    SegmentsFromText(given.segments, "segments"), given.image ? "the array" : given.path, *map);
  return map;
}

using Overlays = std::vector<OverlayVoxels>;

// The volumes of a Python sequence, without labels; empty with a Python error if it holds something
// else.
std::optional<Overlays> OverlaysOf(PyObject* sequence)
{
  Overlays overlays;
  for (Py_ssize_t i = 0; i < PySequence_Size(sequence); ++i)
  {
    PyObject* const item = PySequence_GetItem(sequence, i);
    overlays.push_back(
      { static_cast<vtkImageData*>(vtkPythonUtil::GetPointerFromObject(item, "vtkImageData")) });
    Py_XDECREF(item);
    if (!overlays.back().image)
    {
      return std::nullopt;
    }
  }
  return overlays;
}

struct Rendered
{
  vtkSmartPointer<vtkImageData> picture;
  std::string warning; ///< empty if the picture shows something
};

Rendered RenderScene(const Scene& scene, vtkImageData* volume,
  const std::shared_ptr<const LabelMap>& labels, const Overlays& overlays, VtkMessages& messages)
{
  const ReleasedInterpreter released;
  OffscreenView view(scene, volume, MapperKind::Varimarch);
  view.Pipeline().SetLabels(labels);
  view.Pipeline().SetOverlays(scene.overlays, overlays);
  messages.Observe(view.Pipeline().Mapper());
  messages.Observe(view.Pipeline().Renderer());
  messages.Observe(view.Pipeline().Renderer()->GetRenderWindow());
  view.RenderAll();
  const std::string reason = view.ReasonForNothing(scene);
  return { view.Bytes(), reason.empty() ? "" : "Nothing is visible: " + reason + "." };
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

// Raises warnings in Python. Returns false if the user has made them errors.
bool Warn(const std::vector<std::string>& warnings)
{
  return std::all_of(warnings.begin(), warnings.end(),
    [](const std::string& warning)
    {
      // Level 1 is render(), level 2 its caller.
      return PyErr_WarnEx(PyExc_RuntimeWarning, warning.c_str(), 2) == 0;
    });
}

PyObject* Render(PyObject*, PyObject* arguments)
{
  PyObject* object = nullptr;
  PyObject* overlayObjects = nullptr;
  PyObject* labelObject = Py_None;
  const char* text = nullptr;
  GivenLabels given;
  if (!PyArg_ParseTuple(arguments, "OsO|Osd", &object, &text, &overlayObjects, &labelObject,
        &given.segments, &given.opacity))
  {
    return nullptr;
  }
  auto* const volume =
    static_cast<vtkImageData*>(vtkPythonUtil::GetPointerFromObject(object, "vtkImageData"));
  const std::optional<Overlays> overlays = volume ? OverlaysOf(overlayObjects) : std::nullopt;
  if (!overlays || (labelObject != Py_None && !given.Take(labelObject)))
  {
    return nullptr;
  }
  return ResultOf(
    [&]() -> PyObject*
    {
      VtkMessages messages;
      const auto labels = LabelsOver(volume, given);
      const auto [picture, warning] =
        RenderScene(SceneFromArgument(text), volume, labels, *overlays, messages);
      if (!Warn(messages.Warnings()) || (labels && !Warn(labels->warnings)))
      {
        return nullptr;
      }
      if (const std::vector<std::string> errors = messages.Errors(); !errors.empty())
      {
        throw std::runtime_error(errors.front());
      }
      if (!warning.empty() && !Warn({ warning }))
      {
        return nullptr;
      }
      return vtkPythonUtil::GetObjectFromPointer(picture);
    });
}

PyObject* FieldOfVariations(PyObject*, PyObject* arguments)
{
  PyObject* object = nullptr;
  double tolerance = 0.0;
  const char* distance = nullptr;
  if (!PyArg_ParseTuple(arguments, "Ods", &object, &tolerance, &distance))
  {
    return nullptr;
  }
  auto* const volume =
    static_cast<vtkImageData*>(vtkPythonUtil::GetPointerFromObject(object, "vtkImageData"));
  if (!volume)
  {
    return nullptr;
  }
  return ResultOf(
    [&]
    {
      vtkSmartPointer<vtkImageData> field;
      {
        const ReleasedInterpreter released;
        field = VariationImage(volume, tolerance, ValueOf(VoxelDistanceNames(), distance));
      }
      return vtkPythonUtil::GetObjectFromPointer(field);
    });
}

}

}

PyMODINIT_FUNC PyInit__scene()
{
  static PyMethodDef functions[] = { { "presets", varimarch::Presets, METH_NOARGS,
                                       "() -> JSON text with all presets by their names." },
    { "settings", varimarch::Settings, METH_NOARGS,
      "() -> JSON text with the settings of a scene that render() offers, by their options." },
    { "in_units_of_data", varimarch::PresetInUnitsOfData, METH_VARARGS,
      "(volume, preset) -> the preset with values in the units of the volume's data." },
    { "render", varimarch::Render, METH_VARARGS,
      "(volume, scene, overlays[, labels, segments, opacity]) -> the rendered vtkImageData, whose "
      "first row is the lowest. The overlays are the images of the scene's overlays." },
    { "variation_field", varimarch::FieldOfVariations, METH_VARARGS,
      "(volume, tolerance, distance) -> a vtkImageData of bytes with distances in voxels." },
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
