// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MeshDocuments.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "window/JobRunner.h"

#include <QScopeGuard>
#include <QSemaphore>
#include <QThreadPool>
#include <QtTest>
#include <new>

using namespace handwheel;

namespace {
constexpr int kAll = 100;  // more than any test has jobs
}  // namespace

class JobRunnerTest : public QObject {
  Q_OBJECT

 private slots:
  void jobsRunInOrderAndFinishOnThisThread() {
    QThreadPool pool;
    JobRunner runner(JobRunner::Policy::Queue, pool);
    QStringList order;
    QThread* const here = QThread::currentThread();
    for (const char* name : {"a", "b", "c"}) {
      runner.start({QString::fromLatin1(name), [&, name](Progress) -> Job::Finish {
                      if (QThread::currentThread() == here) qFatal("work on the window thread");
                      return [&, name] {
                        if (QThread::currentThread() != here) qFatal("result off the window thread");
                        order << QString::fromLatin1(name);
                      };
                    }});
    }
    QTRY_VERIFY(runner.isIdle());
    QCOMPARE(order, QStringList({"a", "b", "c"}));
  }

  // A library call that cannot be interrupted does not hold up the user.
  void aCancelledJobIsAbandonedAtOnce() {
    QThreadPool pool;
    QSemaphore release;
    ErrorCode failure = ErrorCode::OutOfMemory;
    bool delivered = false;
    JobRunner runner(JobRunner::Policy::Queue, pool);
    runner.start({"stuck",
                  [&](Progress) -> Job::Finish {
                    release.acquire();
                    return [&] { delivered = true; };
                  },
                  [&](const Error& error) { failure = error.code; }});
    runner.cancelAll();
    QVERIFY(runner.isIdle());
    QCOMPARE(failure, ErrorCode::Cancelled);
    bool next = false;
    runner.start({"next", [&](Progress) -> Job::Finish { return [&] { next = true; }; }});
    QTRY_VERIFY(next);
    release.release();
    pool.waitForDone();
    QTest::qWait(100);
    QVERIFY(!delivered);
  }

  // Too late, the file is there; or in time, and it is not: nobody hears of the end before it has come.
  void aCancelledSaveTellsWhatItDid() {
    QThreadPool pool;
    JobRunner runner(JobRunner::Policy::Queue, pool);
    for (const bool isWritten : {true, false}) {
      QSemaphore release;
      QStringList reported;
      Job job;
      job.lane = Job::Lane::Saving;
      job.failed = [&](const Error&) { reported << "failed"; };
      job.work = [&](Progress progress) -> Job::Finish {
        release.acquire();
        if (isWritten) return [&] { reported << "written"; };
        if (progress.cancelled()) return [&] { reported << "cancelled"; };
        return {};
      };
      runner.start(std::move(job));
      QVERIFY(runner.isBusy(Job::Lane::Saving) && !runner.isBusy(Job::Lane::Work));
      runner.cancelAll();
      QVERIFY(reported.isEmpty() && runner.isBusy(Job::Lane::Saving));
      release.release();
      QTRY_VERIFY(runner.isIdle());
      QCOMPARE(reported, QStringList(isWritten ? "written" : "cancelled"));
    }
  }

  // One job of several: the others go on. What runs and what waits is listed.
  void jobsAreCancelledOneByOne() {
    QThreadPool pool;
    JobRunner runner(JobRunner::Policy::Queue, pool);
    QSemaphore release;
    QStringList done, failed;
    for (const char* name : {"a", "b", "c"}) {
      runner.start({QString::fromLatin1(name),
                    [&, name](Progress) -> Job::Finish {
                      release.acquire();
                      return [&, name] { done << QString::fromLatin1(name); };
                    },
                    [&, name](const Error&) { failed << QString::fromLatin1(name); }});
    }
    const std::vector<JobStatus> all = runner.jobs();
    QCOMPARE(all.size(), std::size_t(3));
    for (std::size_t i = 0; i < 3; ++i) {
      QCOMPARE(all[i].name, QStringList({"a", "b", "c"})[int(i)]);
      QCOMPARE(all[i].isWaiting, i > 0);
    }
    runner.cancel(all[1].id);  // waits
    QCOMPARE(failed, QStringList({"b"}));
    runner.cancel(all[0].id);  // runs
    QCOMPARE(failed, QStringList({"b", "a"}));
    QCOMPARE(runner.jobs().size(), std::size_t(1));
    QVERIFY(!runner.jobs().front().isWaiting);
    release.release(3);
    QTRY_VERIFY(runner.isIdle());
    QCOMPARE(done, QStringList({"c"}));
    runner.cancel(all[2].id);  // has ended
    QCOMPARE(failed.size(), 2);
  }

  // Lanes do not wait for each other; within one, what came first is done first.
  void lanesRunBesideEachOther() {
    QThreadPool pool;
    pool.setMaxThreadCount(3);
    JobRunner runner(JobRunner::Policy::Queue, pool);
    QSemaphore release;
    QStringList done;
    const auto add = [&](const char* name, Job::Lane lane) {
      Job job;
      job.name = QString::fromLatin1(name);
      job.lane = lane;
      job.work = [&release, &done, name = job.name, lane](Progress) -> Job::Finish {
        if (lane == Job::Lane::Work) release.acquire();
        return [&done, name] { done << name; };
      };
      runner.start(std::move(job));
    };
    add("repair", Job::Lane::Work);
    add("compare", Job::Lane::Work);
    add("save", Job::Lane::Saving);
    add("save again", Job::Lane::Saving);
    QTRY_COMPARE(done, QStringList({"save", "save again"}));
    QCOMPARE(runner.jobs().size(), std::size_t(2));
    release.release(2);
    QTRY_VERIFY(runner.isIdle());
    QCOMPARE(done, QStringList({"save", "save again", "repair", "compare"}));
  }

  // Jobs of a document end with it; the jobs of others go on.
  void jobsGoWithTheirOwner() {
    QThreadPool pool;
    JobRunner runner(JobRunner::Policy::Queue, pool);
    QStringList done, failed;
    const int mine = 0, others = 0;
    const auto add = [&](const char* name, const void* owner) {
      runner.start({QString::fromLatin1(name),
                    [&done, name](Progress progress) -> Job::Finish {
                      if (*name == 'a')
                        while (!progress.cancelled()) QThread::msleep(1);
                      return [&done, name] { done << QString::fromLatin1(name); };
                    },
                    [&failed, name](const Error& error) {
                      if (error.code == ErrorCode::Cancelled) failed << QString::fromLatin1(name);
                    },
                    nullptr, owner});
    };
    add("a", &mine);
    add("b", &others);
    add("c", &mine);
    add("d", nullptr);
    runner.cancelOf(&mine);
    QTRY_VERIFY(runner.isIdle());
    QCOMPARE(done, QStringList({"b", "d"}));
    failed.sort();
    QCOMPARE(failed, QStringList({"a", "c"}));
  }

  // A document's jobs run one after another; those of others, and what only looks at it, do not wait for them.
  void documentsDoNotWaitForEachOther() {
    QSemaphore release;
    QThreadPool pool;
    const auto atEnd = qScopeGuard([&] { release.release(kAll); });  // also if the test fails
    pool.setMaxThreadCount(kJobThreads);
    JobRunner runner(JobRunner::Policy::Queue, pool);
    const auto a = test::meshDocument(test::cube()), b = test::meshDocument(test::cube());
    QStringList done;
    const auto add = [&](const char* name, const Document* document, Job::Lane lane, bool isLong = false) {
      Job job;
      job.name = QString::fromLatin1(name);
      job.document = document;
      job.owner = name;
      job.lane = lane;
      job.work = [&, isLong, name = job.name](Progress) -> Job::Finish {
        if (isLong) release.acquire();
        return [&done, name] { done << name; };
      };
      runner.start(std::move(job));
    };
    add("repair a", a.get(), Job::Lane::Work, true);
    add("search a", a.get(), Job::Lane::Looking, true);
    add("fill a", a.get(), Job::Lane::Work);
    add("fill b", b.get(), Job::Lane::Work);
    QTRY_COMPARE(done, QStringList{"fill b"});
    add("measure a", a.get(), Job::Lane::Looking);
    QTRY_COMPARE(done, QStringList({"fill b", "measure a"}));
    QVERIFY(runner.isBusyWith(a.get()) && !runner.isBusyWith(b.get()));
    release.release(2);
    QTRY_VERIFY(runner.isIdle());
    QVERIFY(done.indexOf("repair a") < done.indexOf("fill a"));
    QCOMPARE(done.size(), 5);
  }

  // Two documents that are saved as the same file.
  void whatUsesTheSameFileRunsInOrder() {
    QSemaphore release;
    QThreadPool pool;
    const auto atEnd = qScopeGuard([&] { release.release(kAll); });  // also if the test fails
    pool.setMaxThreadCount(kJobThreads);
    JobRunner runner(JobRunner::Policy::Queue, pool);
    const auto a = test::meshDocument(test::cube()), b = test::meshDocument(test::cube());
    QStringList done;
    const auto save = [&](const Document* document, const char* path, bool isLong) {
      Job job;
      job.document = document;
      job.lane = Job::Lane::Saving;
      job.resource = QString::fromLatin1(path);
      job.work = [&, path, isLong](Progress) -> Job::Finish {
        if (isLong) release.acquire();
        return [&, path, isLong] { done << QString::fromLatin1(path) + (isLong ? " first" : ""); };
      };
      runner.start(std::move(job));
    };
    save(a.get(), "x", true);
    save(b.get(), "x", false);
    save(nullptr, "y", false);
    QTRY_COMPARE(done, QStringList{"y"});
    release.release();
    QTRY_VERIFY(runner.isIdle());
    QCOMPARE(done, QStringList({"y", "x first", "x"}));
  }

  // Neither long jobs nor those of libraries that cannot be interrupted keep a thread from an instant job.
  void abandonedJobsKeepNoThread() {
    QSemaphore release;
    QThreadPool pool;
    const auto atEnd = qScopeGuard([&] { release.release(kAll); });  // also if the test fails
    pool.setMaxThreadCount(1);
    JobRunner runner(JobRunner::Policy::Queue, pool);
    std::atomic<int> stuck{0};
    for (int i = 1; i <= 5; ++i) {
      runner.start({"stuck", [&](Progress) -> Job::Finish {
                      ++stuck;
                      release.acquire();
                      return {};
                    }});
      QTRY_COMPARE(stuck.load(), i);
      runner.cancelAll();
    }
    bool done = false;
    runner.start({"instant", [&](Progress) -> Job::Finish { return [&] { done = true; }; }});
    QTRY_VERIFY(done);
    release.release(5);
    pool.waitForDone();
    // Afterwards there are as many threads as before.
    std::atomic<int> together{0};
    for (int i = 0; i < 2; ++i)
      pool.start([&] {
        ++together;
        release.acquire();
      });
    QTRY_COMPARE(together.load(), 1);
    QTest::qWait(50);
    QCOMPARE(together.load(), 1);
    release.release(2);
    pool.waitForDone();
  }

  // The user takes back what was asked for last in this document, and hears of it.
  void theLatestOfADocumentIsCancelled() {
    QSemaphore release;
    QThreadPool pool;
    const auto atEnd = qScopeGuard([&] { release.release(kAll); });  // also if the test fails
    pool.setMaxThreadCount(kJobThreads);
    JobRunner runner(JobRunner::Policy::Queue, pool);
    const auto a = test::meshDocument(test::cube()), b = test::meshDocument(test::cube());
    QStringList done, failed, said;
    connect(&runner, &JobRunner::cancelled, this, [&](const JobStatus& job, const Document* document) {
      said << job.name;
      QCOMPARE(document, a.get());
    });
    const auto add = [&](const char* name, const Document* document, Job::Lane lane, bool isUnasked = false) {
      Job job;
      job.name = QString::fromLatin1(name);
      job.document = document;
      job.lane = lane;
      job.isUnasked = isUnasked;
      job.work = [&, name](Progress) -> Job::Finish {
        release.acquire();
        return [&, name] { done << QString::fromLatin1(name); };
      };
      job.failed = [&, name](const Error&) { failed << QString::fromLatin1(name); };
      runner.start(std::move(job));
    };
    add("repair", a.get(), Job::Lane::Work);
    add("fill", a.get(), Job::Lane::Work);
    add("search", a.get(), Job::Lane::Looking, true);
    add("save", a.get(), Job::Lane::Saving);
    add("other", b.get(), Job::Lane::Work);
    add("open", nullptr, Job::Lane::Work);
    QVERIFY(runner.cancelLatestOf(a.get()));
    QCOMPARE(failed, QStringList{"fill"});
    QVERIFY(runner.cancelLatestOf(a.get()));
    QCOMPARE(failed, QStringList({"fill", "repair"}));
    QVERIFY(!runner.cancelLatestOf(a.get()));
    QVERIFY(!runner.cancelLatestOf(nullptr));
    QCOMPARE(said, failed);
    for (const JobStatus& job : runner.jobs())
      if (job.name == "search") runner.cancel(job.id);
    QCOMPARE(said.size(), 2);  // nobody asked for it
    release.release(6);
    QTRY_VERIFY(runner.isIdle());
    done.sort();
    QCOMPARE(done, QStringList({"open", "other", "save"}));
  }

  // A file that is being written is written, and a copy that is being made is made.
  void aClosedDocumentTakesItsOwnJobsAlong() {
    QSemaphore release;
    QThreadPool pool;
    const auto atEnd = qScopeGuard([&] { release.release(kAll); });  // also if the test fails
    pool.setMaxThreadCount(kJobThreads);
    JobRunner runner(JobRunner::Policy::Queue, pool);
    auto a = test::meshDocument(test::cube());
    const auto b = test::meshDocument(test::cube());
    QStringList done, failed;
    int said = 0;
    connect(&runner, &JobRunner::cancelled, this, [&] { ++said; });
    const auto add = [&](const char* name, const Document* document, Job::Lane lane, bool outlives = false) {
      Job job;
      job.name = QString::fromLatin1(name);
      job.document = document;
      job.lane = lane;
      job.outlivesDocument = outlives;
      job.work = [&, name](Progress progress) -> Job::Finish {
        release.acquire();
        if (progress.cancelled()) return {};
        return [&, name] { done << QString::fromLatin1(name); };
      };
      job.failed = [&, name](const Error&) { failed << QString::fromLatin1(name); };
      runner.start(std::move(job));
    };
    add("repair", a.get(), Job::Lane::Work);
    add("fill", a.get(), Job::Lane::Work);
    add("search", a.get(), Job::Lane::Looking);
    add("copy", a.get(), Job::Lane::Saving, true);
    add("save", a.get(), Job::Lane::Saving);
    add("other", b.get(), Job::Lane::Work);
    runner.forget(a.get());
    a.reset();
    failed.sort();
    QCOMPARE(failed, QStringList({"fill", "repair", "search"}));
    QCOMPARE(said, 0);
    QCOMPARE(runner.jobs().front().document.isEmpty(), false);  // its name is still known
    release.release(6);
    QTRY_VERIFY(runner.isIdle());
    done.sort();
    QCOMPARE(done, QStringList({"copy", "other", "save"}));
  }

  void theLatestReplacesTheOthersAndWaitsForTheFirstToLetGo() {
    QThreadPool pool;
    JobRunner runner(JobRunner::Policy::Latest, pool);
    std::atomic<int> inside{0};
    std::atomic<bool> together{false};
    int shown = 0;
    for (int i = 1; i <= 5; ++i) {
      runner.start({QString::number(i), [&, i](Progress progress) -> Job::Finish {
                      if (++inside > 1) together = true;
                      while (i < 5 && !progress.cancelled()) QThread::msleep(1);
                      --inside;
                      return [&, i] { shown = i; };
                    }});
    }
    QTRY_VERIFY(runner.isIdle());
    QCOMPARE(shown, 5);
    QVERIFY(!together);
  }

  // A request of one document does not drop that of another.
  void theLatestReplacesThoseOfItsDocument() {
    QSemaphore release;
    QThreadPool pool;
    const auto atEnd = qScopeGuard([&] { release.release(kAll); });  // also if the test fails
    pool.setMaxThreadCount(kJobThreads);
    JobRunner runner(JobRunner::Policy::Latest, pool);
    const auto a = test::meshDocument(test::cube()), b = test::meshDocument(test::cube());
    QStringList done;
    const auto add = [&](const char* name, const Document* document) {
      Job job;
      job.document = document;
      job.work = [&, name](Progress) -> Job::Finish {
        release.acquire();
        return [&, name] { done << QString::fromLatin1(name); };
      };
      runner.start(std::move(job));
    };
    add("a 1", a.get());
    add("b", b.get());
    add("a 2", a.get());
    add("a 3", a.get());
    release.release(4);
    QTRY_VERIFY(runner.isIdle());
    done.sort();
    QCOMPARE(done, QStringList({"a 3", "b"}));
  }

  void runningOutOfMemoryIsReported() {
    QThreadPool pool;
    JobRunner runner(JobRunner::Policy::Queue, pool);
    ErrorCode failure = ErrorCode::Cancelled;
    runner.start({"hungry", [](Progress) -> Job::Finish { throw std::bad_alloc(); },
                  [&](const Error& error) { failure = error.code; }});
    QTRY_VERIFY(runner.isIdle());
    QCOMPARE(failure, ErrorCode::OutOfMemory);
    runner.start({"broken", [](Progress) -> Job::Finish { throw std::logic_error("unexpected"); },
                  [&](const Error& error) { failure = error.code; }});
    QTRY_VERIFY(runner.isIdle());
    QCOMPARE(failure, ErrorCode::LibraryFailed);
  }
};

HANDWHEEL_TEST(JobRunnerTest)
#include "JobRunnerTest.moc"
