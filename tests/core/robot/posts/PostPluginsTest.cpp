// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "AnyProgram.h"
#include "TestClass.h"

#include <QTest>
#include <algorithm>

using namespace handwheel;

namespace {

// A post of a plugin, which writes nothing.
class PluginPost : public PostProcessor {
 public:
  explicit PluginPost(const char* id) : m_id(id) {}
  const char* id() const override { return m_id; }
  const char* title() const override { return "Of a plugin"; }
  const char* ending() const override { return ".arm"; }
  std::string write(const RobotProgram&) const override { return {}; }
  Result<std::vector<ParsedMotion>> read(std::string_view, const RobotProgram&) const override {
    return std::vector<ParsedMotion>();
  }

 private:
  const char* m_id;
};

}  // namespace

// Tests that posts of plugins come after those of the program and do not replace them.
class PostPluginsTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() {  // before posts are needed
    setPluginPosts([this] {
      ++m_asked;
      std::vector<std::unique_ptr<PostProcessor>> all;
      for (const char* const id : {"rapid", "arm", "arm"}) all.push_back(std::make_unique<PluginPost>(id));
      return all;
    });
  }

  void theFirstOfAnIdIsKept() {
    QCOMPARE(std::string(posts().back()->id()), std::string("arm"));
    QCOMPARE(std::count_if(posts().begin(), posts().end(), [](const auto& post) { return post->ending() == kEnding; }),
             std::ptrdiff_t{1});
    QCOMPARE(std::string(postCalled("rapid")->title()), std::string("ABB RAPID"));
    QVERIFY(postCalled("arm") == posts().back().get() && !postCalled("ARM") && !postCalled(""));
    QCOMPARE(m_asked, 1);
  }

  // Extensions of the controllers, in capitals or not; .json alone is a path, and no program.
  void postsByTheEndingOfAFile() {
    for (const auto& [file, id] : {std::pair("weld.mod", "rapid"),
                                   {"/cell/WELD.MOD", "rapid"},
                                   {"weld.src", "krl"},
                                   {"WELD.LS", "fanuc"},
                                   {"weld.script", "urscript"},
                                   {"weld.mod.csv", "csv"},
                                   {"weld.Program.json", "json"},
                                   {"w\xc3\x96.Arm", "arm"}}) {
      const PostProcessor* const post = postForEnding(file);
      QVERIFY2(post, file);
      QCOMPARE(std::string(post->id()), std::string(id));
    }
    for (const char* const other : {"", "mod", "weld.mod.txt", "weldmod", "weld.json"})
      QVERIFY2(!postForEnding(other), other);
  }

 private:
  static constexpr std::string_view kEnding = ".arm";
  int m_asked = 0;
};

HANDWHEEL_TEST(PostPluginsTest)
#include "PostPluginsTest.moc"
