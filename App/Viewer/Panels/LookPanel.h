#ifndef Varimarch_Viewer_LookPanel_h
#define Varimarch_Viewer_LookPanel_h

#include "Scene/Looks/LookFormats/LookContext.h"
#include "Viewer/Model/SceneModel.h"

#include <QGroupBox>
#include <QWidget>

#include <functional>
#include <optional>
#include <utility>
#include <vector>

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QToolButton;
class QVBoxLayout;

namespace varimarch
{

class TransferFunctionEditor;

/// The appearance of the values: transfer function, light, blend mode, presets and look files. The
/// model holds all of it; every change is an edit of the model.
class LookPanel : public QWidget
{
  Q_OBJECT

public:
  explicit LookPanel(SceneModel* model, QWidget* parent = nullptr);

  /// Loads the look of a file into the model, or shows what is wrong with the file.
  void Load(const QString& path);

  /// Saves the model's look under the file's name, or shows why that failed.
  void Save(const QString& path);

private:
  void MakePresets(QVBoxLayout* column);
  void MakeEditor(QVBoxLayout* column);
  QToolButton* MakeColorMaps();
  void ChooseFileToLoad();
  void ChooseFileToSave();
  void Update(ScenePart part);
  void ShowPreset();
  void ShowHistogram();
  LookContext FileContext() const;
  /// Lets the user choose one of several looks. Empty if the user cancels.
  std::optional<std::size_t> ChosenLook(const std::vector<Preset>& presets);
  void Attempt(const std::function<void()>& action);

  SceneModel* model;
  QComboBox* presets;
  QLabel* problem; ///< error of the last file; hidden if there was none
  TransferFunctionEditor* editor;
  QLabel* counted; ///< says that the histogram lacks times; hidden if it has all
};

class NumberSlider;

/// Blend mode of the rays, with the parameters that it needs.
class BlendingForm : public QWidget
{
  Q_OBJECT

public:
  explicit BlendingForm(SceneModel* model, QWidget* parent = nullptr);

private:
  void MakeBlend();
  void MakeUnitDistance();
  void MakeAveragedRange();
  void ChooseBlend(Blend blend);
  void ChooseAveragedRange();
  void ShowUnitDistance(double millimetres, double lengthFactor);
  void Update(ScenePart part);
  void ShowRow(QWidget* field, bool shown);

  SceneModel* model;
  QFormLayout* form;
  QComboBox* blend;
  NumberSlider* unitDistance;
  QWidget* averagedRange;
  QDoubleSpinBox* averagedFirst;
  QDoubleSpinBox* averagedLast;
};

class NumberSlider;

/// The shading, chosen by name or by coefficients. Hidden for blend modes without shading.
class ShadingBox : public QGroupBox
{
  Q_OBJECT

public:
  explicit ShadingBox(SceneModel* model, QWidget* parent = nullptr);

private:
  void MakeKinds();
  void MakeDamping();
  void ShowDampingOf(const Study& study);
  void AddCoefficient(const QString& name, double Shading::*coefficient, NumberSlider* slider);
  void Edit(const QString& name, const Shading& shading, int gesture);
  void Update(ScenePart part);

  SceneModel* model;
  QFormLayout* form;
  QComboBox* kinds;
  NumberSlider* damping;
  std::vector<std::pair<NumberSlider*, double Shading::*>> sliders;
};

}

#endif
