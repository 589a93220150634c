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

/// Draws the present scene from all around, by ours and by a mapper of VTK, and tells the times and
/// the difference of the pictures. Between two pictures the window lives; closing stops it.
class BenchmarkDialog : public QDialog
{
  Q_OBJECT

public:
  /// @param pictureSize  of the pictures to draw
  BenchmarkDialog(SceneModel* model, QSize pictureSize, QWidget* parent = nullptr);
  ~BenchmarkDialog() override;

  void Start();

  /// Ends the orbit where it is; what has been measured stays.
  void Stop();

  bool IsRunning() const { return this->orbit != nullptr; }

  /// Writes what has been measured, as CSV or as PDF by the ending of the name.
  /// @throws std::runtime_error one sentence that names the file
  void Write(const QString& path) const;

signals:
  /// The orbit is complete or stopped.
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
  std::shared_ptr<const Study> study; ///< of the orbit
  std::unique_ptr<OrbitBenchmark> orbit;
  std::vector<OrbitPicture> measured;
  QString measuredKind;
};

}

#endif
