// Random actions in the whole window (RandomUser.h), while it may be busy. Whatever is done, a
// saved session reads back equal, undoing everything returns to the beginning, and VTK reports no
// error. In the end the window closes while it loads.
//
// VARIMARCH_RANDOM_ACTIONS is the number of actions, VARIMARCH_RANDOM_SEED the seed.

#include "LabelledStudy.h"
#include "OverlaidStudy.h"
#include "RandomUser.h"
#include "ScanOfTimes.h"
#include "Scene/Json/SceneFile.h"
#include "Scene/Segments/LabelMap.h"
#include "TorsoWindow.h"

#include <QApplication>
#include <QTimer>

#include <fstream>
#include <iostream>

using namespace varimarch;

namespace
{

/// Gives up dialogs and menus that open while it exists, as the Escape key does.
class DialogsGivenUp
{
public:
  DialogsGivenUp()
  {
    QObject::connect(&this->timer, &QTimer::timeout,
      []
      {
        for (QWidget* const opened :
          { QApplication::activePopupWidget(), QApplication::activeModalWidget() })
        {
          if (opened)
          {
            QTest::keyClick(opened, Qt::Key_Escape);
          }
        }
      });
    this->timer.start(20);
  }

private:
  QTimer timer;
};

/// Resident memory of this process [MB].
double ResidentMegabytes()
{
  long pages = 0;
  long resident = 0;
  std::ifstream("/proc/self/statm") >> pages >> resident;
  return double(resident) * 4096.0 / 1e6;
}

std::string TextOf(const SceneModel* model)
{
  return SceneText(model->CurrentScene());
}

/// The window beside files of each kind.
class RandomUse : public Window
{
protected:
  RandomFiles Files() const
  {
    const LoadedVolume torso =
      LoadVolume(FileSource{ this->Path("torso.vti").toStdString(), std::nullopt });
    vtkNew<vtkXMLImageDataWriter> pet;
    pet->SetInputData(PetOver(torso.image)->volume.image);
    pet->SetFileName(this->Path("pet.vti").toUtf8());
    pet->Write();
    std::ofstream(this->Path("times.nrrd").toStdString()) << NrrdOfTimes();
    const LabelMap labels = LabelMapOf(LabelsOf(torso.image), "labels.nrrd", torso);
    WriteSegments(labels, labels.segments, {}, this->Path("torso.seg.nrrd").toStdString());
    return { this->Path("torso.vti"), this->Path("times.nrrd"), this->Path("pet.vti"),
      this->Path("torso.seg.nrrd") };
  }
};

}

TEST_F(RandomUse, SurvivesRandomActions)
{
  const long count = NumberFromEnvironment("VARIMARCH_RANDOM_ACTIONS", 150);
  const long seed = NumberFromEnvironment("VARIMARCH_RANDOM_SEED", 1);
  this->OpenTorso();
  std::string beginning = TextOf(this->Model());
  const QObject opening;
  QObject::connect(this->window.Loader(), &LoadController::Opened, &opening,
    [&]
    {
      // A further scan is a step.
      beginning = this->Model()->History()->count() == 0 ? TextOf(this->Model()) : beginning;
    });
  const DialogsGivenUp dialogs;
  RandomUser user(&this->window, this->Files(), seed);
  double earlyMegabytes = 0.0;
  for (long number = 1; number <= count; ++number)
  {
    // Printed at once, since a crash leaves no time.
    const std::string place = "seed " + std::to_string(seed) + ", action " + std::to_string(number);
    std::cout << place << ": " << user.Act().toStdString() << std::endl;
    QTest::qWait(number % 7 == 0 ? 60 : 1);
    ASSERT_TRUE(this->window.isVisible()) << place;
    ASSERT_TRUE(this->Model()->CurrentStudy()) << place;

    const std::string now = TextOf(this->Model());
    ASSERT_EQ(SceneText(SceneFromText(now, "session")), now) << place;
    // The last step is undone and repeated after every action, all steps after every 50th.
    QUndoStack* const steps = this->Model()->History();
    const int index = steps->index();
    steps->setIndex(number % 50 == 0 ? 0 : std::max(index - 1, 0));
    ASSERT_TRUE(steps->index() > 0 || TextOf(this->Model()) == beginning) << place;
    steps->setIndex(index);
    ASSERT_EQ(TextOf(this->Model()), now) << place;
    if (number == count / 2)
    {
      earlyMegabytes = ResidentMegabytes();
    }
  }
  EXPECT_LT(ResidentMegabytes(), earlyMegabytes + 150.0);
  user.Open();
  EXPECT_TRUE(this->window.close()) << "while it loads";
}
