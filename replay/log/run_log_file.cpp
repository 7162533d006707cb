#include "continua/replay/log/run_log_file.h"

#include <streambuf>
#include <string_view>

#include "continua/replay/log/kept_documents.h"
#include "continua/replay/log/log_file.h"

namespace continua {

// Holds the first line back until it is whole.
class RunLogFile::Buffer : public std::streambuf {
 public:
  Buffer(std::ostream& out, std::string documents)
      : out_(out), documents_(std::move(documents)), in_header_(!documents_.empty()) {}

  Outcome finish() {
    if (in_header_) put(std::exchange(header_, {}));
    return problem_;
  }

 protected:
  std::streamsize xsputn(const char* text, std::streamsize size) override {
    return take({text, static_cast<std::size_t>(size)}) ? size : 0;
  }
  int_type overflow(int_type letter) override {
    if (traits_type::eq_int_type(letter, traits_type::eof())) return traits_type::not_eof(letter);
    const char one = traits_type::to_char_type(letter);
    return take({&one, 1}) ? letter : traits_type::eof();
  }
  int sync() override { return out_.flush() ? 0 : -1; }

 private:
  bool take(std::string_view text) {
    if (!in_header_) return put(text);
    const auto end = text.find('\n');
    header_.append(text.substr(0, end));
    if (end == text.npos) return true;
    in_header_ = false;
    const auto lean = without_documents(header_);
    header_.clear();
    problem_ = keep_documents(lean, documents_);
    return !problem_ && put(lean.line) && put(text.substr(end));
  }
  bool put(std::string_view text) {
    return static_cast<bool>(out_.write(text.data(), static_cast<std::streamsize>(text.size())));
  }

  std::ostream& out_;
  const std::string documents_;
  std::string header_;
  bool in_header_;
  Outcome problem_;
};

RunLogFile::RunLogFile(const std::string& path, const std::string& documents)
    : file_(path), buffer_(std::make_unique<Buffer>(file_.stream(), documents)), stream_(buffer_.get()) {
  if (!file_.stream()) stream_.setstate(std::ios::badbit);
}

RunLogFile::~RunLogFile() = default;

Outcome RunLogFile::commit() {
  if (auto problem = buffer_->finish()) return problem;
  return file_.commit();
}

Outcome rewrite_run_log(const std::string& from, const std::string& path, const std::string& documents) {
  const auto source = source_of_log(from);
  if (!source) return source.error();
  RunLogFile file(path, documents);
  auto problem = read_pieces(**source, from, [&](std::string_view piece) {
    file.stream().write(piece.data(), static_cast<std::streamsize>(piece.size()));
  });
  if (problem) return problem;
  return file.commit();
}

}  // namespace continua
