#pragma once

#include <fairlight/validation/studies/study.h>

/// The studies, each in the file of its name. They write their pictures to the folder of the options.
namespace fairlight::studies_of_paper {

StudyResult fig1(const StudyOptions& options);
StudyResult fig2(const StudyOptions& options);
StudyResult fig3(const StudyOptions& options);
StudyResult fig4(const StudyOptions& options);
StudyResult fig5(const StudyOptions& options);
StudyResult fig6(const StudyOptions& options);
StudyResult fig7(const StudyOptions& options);
StudyResult a1(const StudyOptions& options);
StudyResult a2(const StudyOptions& options);
StudyResult cost(const StudyOptions& options);
StudyResult montelight(const StudyOptions& options);

}  // namespace fairlight::studies_of_paper
