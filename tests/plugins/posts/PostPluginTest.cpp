// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "BuildPaths.h"
#include "builtin/PluginPosts.h"

#include "TestClass.h"
#include "posts/AnyProgram.h"

#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// A folder with a cell in which a path is planned, and the program with these plugins.
class Cell {
 public:
  explicit Cell(const char* plugins) : m_plugins(plugins) {
    QCOMPARE(run({"configuration", "irb120", "--add", "left", "--joints", "joint_1=1", "-o", "cell.handwheel"}), 0);
    QCOMPARE(
        run({"configuration", "cell.handwheel", "--add", "right", "--joints", "joint_1=-1", "-o", "cell.handwheel"}),
        0);
    QCOMPARE(run({"plan", "cell.handwheel", "--from", "left", "--to", "right", "-o", "cell.handwheel"}), 0);
  }
  int run(const QStringList& words) {
    QProcess process;
    process.setWorkingDirectory(m_folder.path());
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("HANDWHEEL_PLUGINS", m_plugins);
    process.setProcessEnvironment(environment);
    process.start(test::programPath(), words);
    process.waitForFinished(120'000);
    complaints = process.readAllStandardError();
    return process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1;
  }
  bool has(const char* name) const { return QFile::exists(m_folder.filePath(name)); }

  QByteArray complaints;

 private:
  QTemporaryDir m_folder;
  QString m_plugins;
};

}  // namespace

// Posts that are loaded at run time.
class PostPluginTest : public QObject {
  Q_OBJECT

 private slots:
  // A written program is verified like that of the program's own posts.
  void writtenAndRead_data() {
    QTest::addColumn<QByteArray>("robot");
    for (const char* id : {"irb120", "kr6r900", "ur5"}) QTest::newRow(id) << QByteArray(id);
  }
  void writtenAndRead() {
    QFETCH(const QByteArray, robot);
    qputenv("HANDWHEEL_PLUGINS", test::buildPath("tests/plugins").toUtf8());
    const auto posts = pluginPosts();
    QCOMPARE(posts.size(), std::size_t{1});
    QCOMPARE(QByteArray(posts[0]->id()), QByteArray("example"));
    QVERIFY(rc::check("the example", [&] { checkAnyProgram(*posts[0], robot.constData()); }));
  }

  void hostileTexts() {
    qputenv("HANDWHEEL_PLUGINS", test::buildPath("tests/plugins").toUtf8());
    const auto posts = pluginPosts();
    QCOMPARE(posts.size(), std::size_t{1});
    for (const char* text :
         {"MOVE 1 2 3", "JOINT 1 2 3 SPEED 4", "LINE 1 2 3 0 0 0 0 SPEED 1", "JOINT 1e999 0 0 0 0 0"})
      QVERIFY2(!posts[0]->read(text, programOf("irb120")).hasValue(), text);
    const auto none = posts[0]->read("", programOf("irb120"));
    QVERIFY(none.hasValue() && none->empty());
  }

  void onTheCommandLine() {
    Cell cell(test::buildPath("tests/plugins").toUtf8());
    QVERIFY2(cell.run({"post", "cell.handwheel", "path", "--controller", "example", "-o", "p.moves"}) == 0,
             cell.complaints);
    QVERIFY2(cell.run({"verify", "cell.handwheel", "p.moves"}) == 0, cell.complaints);
  }

  // None of its code runs; the program reports the file, and has its own posts nevertheless.
  void madeForAnotherVersion() {
    Cell cell(test::buildPath("tests/old-plugins").toUtf8());
    QCOMPARE(cell.run({"post", "cell.handwheel", "path", "--controller", "rapid", "-o", "p.mod"}), 0);
    QVERIFY(cell.has("p.mod"));
    QVERIFY2(cell.complaints.contains("OldPost.so") && cell.complaints.contains("another version"), cell.complaints);
    QCOMPARE(cell.run({"post", "cell.handwheel", "path", "--controller", "example", "-o", "p.moves"}), 1);
  }
};

HANDWHEEL_TEST(PostPluginTest)
#include "PostPluginTest.moc"
