// A worker program for the pool's tests: jobs that answer, and jobs that go wrong in every way.
#include "engine/study/workers/worker.h"

#include <array>
#include <csignal>
#include <cstdlib>
#include <iostream>
#include <stdexcept>
#include <thread>

namespace plumbline::study {
namespace {

Result<std::string> echo(const std::string& body) {
    return body;
}
/// To be answered by a body of so many letters.
Result<std::string> many(const std::string& body) {
    return std::string(static_cast<std::size_t>(std::atoi(body.c_str())), 'x');
}
Result<std::string> crash(const std::string&) {
    std::signal(SIGSEGV, SIG_DFL);  // a sanitizer would make an exit code of it
    std::raise(SIGSEGV);
    return std::string();
}
Result<std::string> leave(const std::string&) {
    std::exit(7);
}
Result<std::string> hang(const std::string&) {
    for (;;) std::this_thread::sleep_for(std::chrono::seconds(1));
}
Result<std::string> fail(const std::string& body) {
    throw std::runtime_error(body);
}
Result<std::string> chatter(const std::string&) {
    std::cout << "no answer" << std::endl;
    return std::string("after chatter");
}

constexpr std::array<JobKind, 7> kKinds{{{"echo", each_by_itself<echo>},
                                         {"many", each_by_itself<many>},
                                         {"crash", each_by_itself<crash>},
                                         {"leave", each_by_itself<leave>},
                                         {"hang", each_by_itself<hang>},
                                         {"fail", each_by_itself<fail>},
                                         {"chatter", each_by_itself<chatter>}}};

}  // namespace
}  // namespace plumbline::study

int main() {
    plumbline::study::serve_jobs(plumbline::study::kKinds, std::cin, std::cout);
    return 0;
}
