// The folder of a plan, whatever its chunks are: which of them are done, and by which builds.
#include "works/plan_folder.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "runs/json.h"
#include "support/files.h"
#include "util/diagnostics.h"
#include "util/files/atomic_file.h"
#include "works/build_facts.h"

using namespace carom;

namespace {

Json own_build() { return to_json(physics_build_facts()); }

Json another_build() {
    Json build = own_build();
    build["source"] = "another";
    return build;
}

// A plan of two chunks.
struct Planned {
    test::TemporaryFolder folder;

    Planned() {
        PlanWriter writer(folder.path() / "plan");
        writer.write("film.plan", "what all chunks share");
        writer.commit({PlanKind::film, {{"build", own_build()}}, {{"film", Json::object()}}},
                      {{.number = 1, .first = 0, .end = 3}, {.number = 2, .first = 3, .end = 5}});
    }
    PlanFolder plan() const { return PlanFolder(folder.path() / "plan"); }

    void make(int number, const Json& build) const {
        const PlanFolder its = plan();
        write_file(its.output(its.chunk(number)), std::string("what it makes"));
        its.finish(its.chunk(number), build, 1.0);
    }
};

}  // namespace

TEST_CASE("a plan is done when all of its chunks are, each with its manifest") {
    const Planned work;
    CHECK(work.plan().missing() == std::vector<int>{1, 2});
    CHECK(work.plan().read("film.plan") == "what all chunks share");
    work.make(2, own_build());
    CHECK(work.plan().missing() == std::vector<int>{1});
    CHECK_THROWS_AS(work.plan().require_all_done(false), UsageError);
    const PlanFolder plan = work.plan();
    write_file(plan.output(plan.chunk(1)), std::string("an output without a manifest"));
    CHECK(plan.missing() == std::vector<int>{1});
    work.make(1, own_build());
    CHECK(plan.missing().empty());
    CHECK_NOTHROW(plan.require_all_done(false));
}

TEST_CASE("chunks of another build are refused, unless they are allowed") {
    const Planned work;
    CHECK_NOTHROW(work.plan().require_same_build(own_build()));
    CHECK_THROWS_AS(work.plan().require_same_build(another_build()), UsageError);
    work.make(1, own_build());
    work.make(2, another_build());
    CHECK_THROWS_AS(work.plan().require_all_done(false), SystemError);
    CHECK_NOTHROW(work.plan().require_all_done(true));
}

TEST_CASE("the same request is planned once, and other files than those of a plan stay") {
    const Planned work;
    CHECK(is_planned(work.folder.path() / "plan", {{"build", own_build()}}));
    CHECK_FALSE(is_planned(work.folder.path() / "plan", {{"build", another_build()}}));
    work.folder.write("other/notes.txt", "mine");
    CHECK_THROWS_AS(PlanWriter(work.folder.path() / "other"), UsageError);
    CHECK(work.folder.names() == std::vector<std::string>{"other", "plan"});
}
