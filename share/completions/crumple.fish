# fish completion for crumple(1): the program itself says what may come next
function __crumple_complete
    set -l words (commandline -opc) (commandline -ct)
    $words[1] --completions $words[2..-1] 2>/dev/null
end
complete -c crumple -a '(__crumple_complete)'
