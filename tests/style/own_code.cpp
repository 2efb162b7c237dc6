// SPDX-License-Identifier: GPL-3.0-or-later
// For clang-tidy: its checks look at what the project declares, and not at the headers of other libraries too, of which they
// would say nothing. Two fifths of the time. clang-tidy 21 does so by itself.
#include <clang-tidy/ClangTidyCheck.h>
#include <clang-tidy/ClangTidyModule.h>
#include <clang-tidy/ClangTidyModuleRegistry.h>
#include <clang/AST/ASTContext.h>
#include <clang/ASTMatchers/ASTMatchers.h>
#include <clang/Basic/SourceManager.h>

#include <vector>

namespace {

using clang::ast_matchers::MatchFinder;

/// The translation unit is the first thing that is matched. Then follows what lies in its scope, as it is by then.
class OwnCode : public clang::tidy::ClangTidyCheck {
 public:
  using ClangTidyCheck::ClangTidyCheck;
  void registerMatchers(MatchFinder* finder) override {
    finder->addMatcher(clang::ast_matchers::translationUnitDecl().bind("unit"), this);
  }
  void check(const MatchFinder::MatchResult& result) override {
    std::vector<clang::Decl*> ours;
    for (clang::Decl* declared : result.Context->getTranslationUnitDecl()->decls()) {
      const clang::SourceLocation at = declared->getLocation();
      if (at.isValid() && !result.SourceManager->isInSystemHeader(at)) ours.push_back(declared);
    }
    result.Context->setTraversalScope(ours);
  }
};

class OwnCodeModule : public clang::tidy::ClangTidyModule {
 public:
  void addCheckFactories(clang::tidy::ClangTidyCheckFactories& factories) override {
    factories.registerCheck<OwnCode>("impinge-own-code");
  }
};

const clang::tidy::ClangTidyModuleRegistry::Add<OwnCodeModule> kModule("impinge", "");

}  // namespace
