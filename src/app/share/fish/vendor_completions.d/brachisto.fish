# Completion of brachisto for fish: the program says what may follow.

function __brachisto_offers
    set -l words (commandline -opc)
    set -l last (commandline -ct)
    for line in ($words[1] complete -- $words[2..-1] "$last" 2> /dev/null)
        switch $line
            case :files
                __fish_complete_suffix .yaml
                __fish_complete_suffix .json
            case :directories
                __fish_complete_directories $last
            case '*'
                echo $line
        end
    end
end

complete -c brachisto -f -k -a '(__brachisto_offers)'
