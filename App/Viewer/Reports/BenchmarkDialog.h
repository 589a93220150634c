#ifndef Varimarch_Viewer_BenchmarkDialog_h
#define Varimarch_Viewer_BenchmarkDialog_h

#include "Scene/Images/OffscreenView.h"
#include "Viewer/Model/SceneModel.h"

#include <QDialog>
#include <QSize>

#include <memory>
#include <string>
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

/// One view of an orbit, rendered by our mapper and by one of VTK's. Errors compare VTK's image
/// with ours, in 1/255 of full brightness.
struct OrbitPicture
{
  double degrees; ///< azimuth from the scene's camera
  double oursMs;
  double theirsMs;
  double rootMeanSquare;
  double largest; ///< over all pixels and channels
};

/// Renders a scene from all around with two mappers. Each call renders one view, so that a program
/// stays responsive.
class OrbitBenchmark
{
public:
  /// Renders a first frame with both mappers, which pays for their one-time setup.
  /// @param theirs  a mapper that supports the scene's blend mode, see CanBlend
  /// @param image   the scene's volume; must outlive this object
  /// @throws std::runtime_error with one sentence if there is no OpenGL
  OrbitBenchmark(const Scene& scene, vtkImageData* image, MapperKind theirs, int pictures);

  /// Draws labels over the volume from now on.
  /// @param segments  their look, see ScenePipeline::SetSegments
  void ShowLabels(std::shared_ptr<const LabelMap> labels, const std::vector<Segment>& segments);

  bool IsDone() const { return int(this->drawn.size()) == this->count; }
  void DrawNext();

  const std::vector<OrbitPicture>& Pictures() const { return this->drawn; }

private:
  OffscreenView ours;
  OffscreenView theirs;
  int count;
  std::vector<OrbitPicture> drawn;
};

/// Median times and worst errors of at least one view.
struct OrbitSummary
{
  double medianOursMs;
  double medianTheirsMs;
  double rootMeanSquare; ///< over all views
  double largest;
};

OrbitSummary SummaryOf(const std::vector<OrbitPicture>& pictures);

/// A header line, then a line per view: "degrees,ours_ms,vtk_ms,rmse_255,largest_255".
std::string CsvOf(const std::vector<OrbitPicture>& pictures);

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
