#ifndef Varimarch_Viewer_LookPanel_h
#define Varimarch_Viewer_LookPanel_h

#include "Viewer/Model/SceneModel.h"

#include <QWidget>

#include <functional>
#include <utility>
#include <vector>

class QComboBox;
class QFormLayout;
class QGroupBox;
class QLabel;
class QVBoxLayout;

namespace varimarch
{

class NumberSlider;
class TransferFunctionEditor;

/// How the values of the volume are seen: transfer function, light, blending, presets and files of
/// looks. All of it is the model's; every change here is an edit of it.
class LookPanel : public QWidget
{
  Q_OBJECT

public:
  explicit LookPanel(SceneModel* model, QWidget* parent = nullptr);

  /// The look of a file becomes the model's, or the panel says what is wrong with it.
  void Load(const QString& path);

  /// Writes the model's look under the file's name, or the panel says why it could not.
  void Save(const QString& path);

private:
  void MakePresets(QVBoxLayout* column);
  void MakeEditor(QVBoxLayout* column);
  void MakeBlending(QVBoxLayout* column);
  void MakeShading(QVBoxLayout* column);
  void AddCoefficient(const QString& name, double Shading::*coefficient, NumberSlider* slider);
  void ChooseFileToLoad();
  void ChooseFileToSave();
  void Update(ScenePart part);
  void ShowPreset();
  void EditLook(const QString& name, int gesture, const std::function<void(Look&)>& change);
  void Attempt(const std::function<void()>& action);

  SceneModel* model;
  QComboBox* presets;
  QLabel* problem; ///< of the last file; hidden when there was none
  TransferFunctionEditor* editor;
  QComboBox* blend;
  NumberSlider* unitDistance;
  QGroupBox* shading;
  QFormLayout* coefficients;
  std::vector<std::pair<NumberSlider*, double Shading::*>> sliders;
};

}

#endif
