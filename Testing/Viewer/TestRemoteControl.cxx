// Scripts that drive the window through its local socket: looks go both ways, and no message harms.

#include "OverlaidStudy.h"
#include "Scene/Json/SceneFile.h"
#include "Scene/Looks/Presets.h"
#include "TorsoWindow.h"
#include "Viewer/Remote/RemoteControl.h"

#include <QComboBox>
#include <QFileInfo>
#include <QLocalSocket>

#include <nlohmann/json.hpp>

#include <stdexcept>

using namespace varimarch;

class RemoteWindow : public Window
{
protected:
  RemoteWindow()
  {
    this->control->Listen(this->Path("socket"));
    this->script.connectToServer(this->Path("socket"));
  }

  nlohmann::json Ask(const std::string& message)
  {
    this->script.write(QByteArray::fromStdString(message + "\n"));
    EXPECT_TRUE(QTest::qWaitFor([&] { return this->script.canReadLine(); }, MostMilliseconds));
    return nlohmann::json::parse(this->script.readLine().toStdString());
  }

  RemoteControl* control = new RemoteControl(&this->window);
  QLocalSocket script;
};

TEST_F(RemoteWindow, ShowsTheLookOfAScriptAsAStepToUndo)
{
  EXPECT_EQ(this->Ask(R"({"get": "status"})")["status"], "empty");
  EXPECT_TRUE(this->Ask(R"({"get": "look"})").contains("error")) << "no volume yet";
  this->OpenTorso();
  EXPECT_EQ(this->Ask(R"({"get": "status"})")["status"], "shown");
  QSignalSpy drawn(this->View(), &VolumeView::Drawn);
  EXPECT_EQ(this->Ask(R"({"set": "ct-lung"})")["done"], true);
  EXPECT_EQ(this->Model()->CurrentScene().look.name, "ct-lung");
  EXPECT_TRUE(QTest::qWaitFor([&] { return !drawn.isEmpty(); }, MostMilliseconds));
  EXPECT_EQ(this->Model()->History()->count(), 1);
  this->Model()->History()->undo();
  EXPECT_EQ(this->Ask(R"({"get": "look"})")["look"]["name"], "ct-bone");
}

TEST_F(RemoteWindow, TellsWhatTheUserHasEdited)
{
  this->OpenTorso();
  auto* const blend = this->window.findChild<QComboBox*>("blend");
  blend->setCurrentText("Maximum");
  emit blend->activated(blend->currentIndex());
  const nlohmann::json look = this->Ask(R"({"get": "look"})")["look"];
  EXPECT_EQ(look["blend"], "maximum");
  const nlohmann::json request = { { "set", look } };
  EXPECT_EQ(this->Ask(request.dump())["done"], true) << "what is read can be set";
  EXPECT_EQ(LookText(this->Model()->CurrentScene().look),
    LookText(PresetFromText(look.dump(), "look").look));
}

TEST_F(RemoteWindow, TellsAndSetsTheLookOfTheSameVolume)
{
  this->OpenTorso();
  AddPet(*this->Model());
  EXPECT_EQ(this->Ask(R"({"get": "look"})")["look"]["name"], "pet-hot");
  EXPECT_EQ(this->Ask(R"({"set": "mr-head"})")["done"], true);
  EXPECT_EQ(this->Ask(R"({"get": "look"})")["look"]["name"], "mr-head");
  EXPECT_EQ(this->Model()->CurrentScene().look.name, "ct-bone");
}

TEST_F(RemoteWindow, AnswersABadMessageInOneSentenceAndGoesOn)
{
  this->OpenTorso();
  const std::string before = SceneText(this->Model()->CurrentScene());
  const std::pair<std::string, std::string> cases[] = {
    { "", "not valid JSON" },
    { "{\"set\": ", "not valid JSON" },
    { "\xff\xfe", "not valid JSON" },
    { "[]", "expected an object" },
    { R"({"quit": true})", "unknown key \"quit\"" },
    { R"({"get": "volume"})", "unknown value \"volume\"" },
    { R"({"set": "ct-bones"})", "did you mean \"ct-bone\"?" },
    { R"({"set": {"colors": []}})", "expected an array of 1 to" },
    { R"({"set": )" + std::string(100000, '[') + "}", "levels of brackets" },
    { std::string(3 << 20, ' '), "expected at most 1048576 bytes" },
  };
  for (const auto& [message, sentence] : cases)
  {
    const std::string error = this->Ask(message).value("error", "");
    EXPECT_NE(error.find(sentence), std::string::npos) << error;
    EXPECT_EQ(error.find('\n'), std::string::npos) << error;
  }
  EXPECT_EQ(SceneText(this->Model()->CurrentScene()), before);
  EXPECT_EQ(this->Ask(R"({"get": "status"})")["status"], "shown");
}

TEST_F(RemoteWindow, TellsWhyAFileCannotBeOpened)
{
  this->window.Open(this->Path("missing.vti"));
  ASSERT_TRUE(QTest::qWaitFor(
    [&] { return this->Ask(R"({"get": "status"})")["status"] == "failed"; }, MostMilliseconds));
  const std::string reason = this->Ask(R"({"get": "status"})")["reason"];
  EXPECT_NE(reason.find("missing.vti"), std::string::npos) << reason;
  this->OpenTorso();
  EXPECT_EQ(this->Ask(R"({"get": "status"})")["status"], "shown");
}

TEST_F(RemoteWindow, OnlyTheCurrentUserMayConnect)
{
  const QFile::Permissions others = QFile::ReadGroup | QFile::WriteGroup | QFile::ExeGroup |
    QFile::ReadOther | QFile::WriteOther | QFile::ExeOther;
  EXPECT_FALSE(QFileInfo(this->Path("socket")).permissions() & others);
}

TEST_F(RemoteWindow, ANameThatIsTakenIsRefused)
{
  RemoteControl second(&this->window);
  try
  {
    second.Listen(this->Path("socket"));
    FAIL();
  }
  catch (const std::runtime_error& error)
  {
    EXPECT_NE(std::string(error.what()).find("socket"), std::string::npos) << error.what();
  }
}

TEST_F(RemoteWindow, StaysWhenTheScriptGoesAndGoesOnWithAnother)
{
  this->OpenTorso();
  this->script.disconnectFromServer();
  QTest::qWait(50);
  this->script.connectToServer(this->Path("socket"));
  EXPECT_EQ(this->Ask(R"({"set": "ct-lung"})")["done"], true);
}
