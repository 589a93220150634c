#ifndef Varimarch_Viewer_LookPanel_h
#define Varimarch_Viewer_LookPanel_h

#include "Scene/LookFormats/LookContext.h"
#include "Viewer/Model/SceneModel.h"

#include <QWidget>

#include <functional>

class QComboBox;
class QLabel;
class QToolButton;
class QVBoxLayout;

namespace varimarch
{

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
  QToolButton* MakeColorMaps();
  void ChooseFileToLoad();
  void ChooseFileToSave();
  void Update(ScenePart part);
  void ShowPreset();
  LookContext FileContext() const;
  void Attempt(const std::function<void()>& action);

  SceneModel* model;
  QComboBox* presets;
  QLabel* problem; ///< of the last file; hidden when there was none
  TransferFunctionEditor* editor;
};

}

#endif
