# Completion of continua in fish: the program itself tells how a line may go on.
function __continua_words
    set -l words (commandline -opc)
    $words[1] complete -- $words[2..-1] (commandline -ct) 2>/dev/null
end
complete -c continua -f -a '(__continua_words)'
