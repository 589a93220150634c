#ifndef Varimarch_Viewer_LookPanel_h
#define Varimarch_Viewer_LookPanel_h

#include "Scene/LookFormats/LookContext.h"
#include "Viewer/Model/SceneModel.h"

#include <QWidget>

#include <functional>
#include <optional>
#include <vector>

class QComboBox;
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

}

#endif
