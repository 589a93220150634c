// The window after a reset of the graphics card. A test answers in place of the driver.

#include "Scene/Json/SceneFile.h"
#include "Support/ResettingDriver.h"
#include "TorsoWindow.h"

#include <QMessageBox>
#include <QOpenGLContext>
#include <QPointer>
#include <QWindow>

#include <vtkCallbackCommand.h>
#include <vtkRenderWindow.h>

#include <optional>

using namespace varimarch;

namespace
{

class WindowAfterReset : public Window
{
protected:
  /// Opens the torso, changes something, and waits for its fine image.
  void PrepareWork()
  {
    this->OpenTorso();
    this->View()->SetRefining(false);
    this->Model()->Edit(ScenePart::Cuts, "cut", [](Scene& scene) { scene.cuts.box[0] = 0.25; });
    this->AwaitFineImage();
    vtkNew<vtkCallbackCommand> count;
    count->SetClientData(&this->errorCount);
    count->SetCallback(
      [](vtkObject*, unsigned long, void* errors, void*) { ++*static_cast<int*>(errors); });
    this->View()->Pipeline()->Mapper()->AddObserver(vtkCommand::ErrorEvent, count);
  }

  void AwaitFineImage()
  {
    bool isFine = false;
    const QObject drawing;
    QObject::connect(this->View(), &VolumeView::Drawn, &drawing,
      [&] { isFine = this->View()->RenderWindow()->GetDesiredUpdateRate() < 0.1; });
    ASSERT_TRUE(QTest::qWaitFor([&] { return isFine; }, MostMilliseconds));
  }

  QString Text() { return QString::fromStdString(SceneText(this->Model()->CurrentScene())); }

  /// The sentences that the window says since the last call.
  QStringList Sentences()
  {
    QStringList texts;
    for (QMessageBox* const box : this->window.findChildren<QMessageBox*>())
    {
      texts << box->text();
      delete box;
    }
    return texts;
  }

  int errorCount = 0; ///< errors of the mapper
};

}

TEST_F(WindowAfterReset, DrawsAnewAndLosesNothing)
{
  this->PrepareWork();
  if (!ResettingDriver::CanTell())
  {
    GTEST_SKIP() << "the driver cannot tell";
  }
  const QImage before = this->Surface()->grabFramebuffer();
  const QString scene = this->Text();
  const QByteArray layout = this->window.saveState();
  const QSize size = this->window.size();
  const QPointer<QOpenGLContext> context = this->Surface()->context();
  const QPointer<QWindow> native = this->window.windowHandle();

  const ResettingDriver driver(1);
  this->View()->RenderWindow()->Render();
  this->AwaitFineImage();
  EXPECT_EQ(this->Sentences(),
    QStringList{ "The graphics card was reset, and the image is drawn anew; nothing is lost." });
  EXPECT_TRUE(context.isNull()) << "the context was lost";
  EXPECT_TRUE(native.isNull()) << "and the one of the window, with which it is shared";
  EXPECT_EQ(this->Surface()->grabFramebuffer(), before);
  EXPECT_EQ(this->Text(), scene);
  EXPECT_EQ(this->window.saveState(), layout);
  EXPECT_EQ(this->window.size(), size);
  EXPECT_EQ(this->errorCount, 1);

  this->Model()->History()->undo();
  this->AwaitFineImage();
  EXPECT_NE(this->Surface()->grabFramebuffer(), before);
}

TEST_F(WindowAfterReset, KeepsTheWorkIfTheCardIsResetAgainAndAgain)
{
  this->PrepareWork();
  if (!ResettingDriver::CanTell())
  {
    GTEST_SKIP() << "the driver cannot tell";
  }
  const QString scene = this->Text();
  // Every frame is lost. A new context has asked the driver for its functions before.
  std::optional<ResettingDriver> driver;
  vtkNew<vtkCallbackCommand> reset;
  reset->SetClientData(&driver);
  reset->SetCallback([](vtkObject*, unsigned long, void* driver, void*)
    { static_cast<std::optional<ResettingDriver>*>(driver)->emplace(1); });
  vtkObject* const mapper = this->View()->Pipeline()->Mapper();
  mapper->AddObserver(vtkCommand::VolumeMapperRenderStartEvent, reset);
  this->View()->RenderWindow()->Render();
  QStringList sentences;
  const auto hasGivenUp = [&]
  {
    sentences += this->Sentences();
    return sentences.size() >= 2;
  };
  ASSERT_TRUE(QTest::qWaitFor(hasGivenUp, MostMilliseconds));
  EXPECT_TRUE(sentences.last().contains("save the session")) << sentences.last().toStdString();
  this->Model()->Edit(ScenePart::Background, "gray",
    [](Scene& scene) {
      scene.background = { 0.5, 0.5, 0.5 };
    });
  QTest::qWait(500);
  EXPECT_TRUE(this->Sentences().isEmpty()) << "it is told once";
  this->Model()->History()->undo();
  EXPECT_EQ(this->Text(), scene);
  EXPECT_TRUE(this->window.isVisible());
  mapper->RemoveObserver(reset);
}
