#ifndef Varimarch_Viewer_BenchmarkDialog_h
#define Varimarch_Viewer_BenchmarkDialog_h

#include "Scene/OrbitBenchmark.h"
#include "Viewer/Model/SceneModel.h"

#include <QDialog>
#include <QSize>

#include <memory>
#include <vector>

class QComboBox;
class QFormLayout;
class QLabel;
class QProgressBar;
class QPushButton;
class QSpinBox;
class QTableWidget;

namespace varimarch
{

/// Renders the current scene from all around with our mapper and one of VTK's, and lists the times
/// and the differences of the images. The window stays responsive between views; closing it stops
/// the benchmark.
class BenchmarkDialog : public QDialog
{
  Q_OBJECT

public:
  /// @param pictureSize  of the rendered images
  BenchmarkDialog(SceneModel* model, QSize pictureSize, QWidget* parent = nullptr);
  ~BenchmarkDialog() override;

  void Start();

  /// Stops after the current view and keeps the results.
  void Stop();

  bool IsRunning() const { return this->orbit != nullptr; }

  /// Writes the results as CSV or PDF, depending on the extension.
  /// @throws std::runtime_error with one sentence that names the file
  void Write(const QString& path) const;

signals:
  /// The orbit is complete or was stopped.
  void Ended();

protected:
  void done(int result) override;

private:
  QWidget* MakeChoices();
  void MakeTable();
  void MakeButtons();
  void Continue();
  void AddRow(const OrbitPicture& picture);
  void ShowState();
  void Export();
  MapperKind ChosenKind() const;

  SceneModel* model;
  QSize pictureSize;
  QComboBox* kind;
  QSpinBox* count;
  QProgressBar* progress;
  QTableWidget* table;
  QLabel* summary;
  QPushButton* start;
  QPushButton* save;
  std::shared_ptr<const Study> study; ///< volume of the orbit
  std::unique_ptr<OrbitBenchmark> orbit;
  std::vector<OrbitPicture> measured;
  QString measuredKind;
};

}

#endif
